// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/mouth_layout.h"

namespace tactooth::test {

/// The outer surface of a tooth in its pose.
[[nodiscard]] TriangleMesh placed(const BuiltinMouth& in, int fdi);

/// Smallest distance of a vertex of one from the other, negative if one is inside; at most 1 mm.
[[nodiscard]] double between(const TriangleMesh& a, const TriangleMesh& b);

/// Both gingivae: closed, oriented, one component, and without self-intersections according to CGAL.
void expectValidGingivae(const MouthLayout& layout);

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/mouth_layout.h"

namespace tactooth::test {

/// The outer surface of a tooth where it stands.
[[nodiscard]] TriangleMesh placed(const BuiltinMouth& in, int fdi);

/// Smallest distance of a vertex of the one from the other, negative if one lies inside; at most 1 mm.
[[nodiscard]] double between(const TriangleMesh& a, const TriangleMesh& b);

/// Both gums: closed, oriented, of one piece, and not intersecting themselves as CGAL judges.
void expectValidGingivae(const MouthLayout& layout);

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle_mesh.h"

namespace tactooth::test {

/// The same surface with four triangles for each: cut at the middles of the edges, which stay where they are.
[[nodiscard]] TriangleMesh subdivided(const TriangleMesh& mesh);

}  // namespace tactooth::test

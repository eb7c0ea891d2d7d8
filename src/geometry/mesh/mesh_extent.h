// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Largest coordinate of a surface that is touched or cut, mm: a thousand jaws. Beyond it single precision is coarser
/// than a tenth of a millimetre, and finding a contact takes seconds.
inline constexpr double kMaxCoordinate = 1e6;

/// Fails with a part of a sentence if a corner is farther away. `what`: "the surface of the tooth".
[[nodiscard]] Expected<void> checkExtent(const TriangleMesh& mesh, const Message& what);

}  // namespace tactooth

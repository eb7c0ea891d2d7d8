// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Fails with a part of a sentence if a coordinate of a vertex is beyond kMaxCoordinate. `what` is its subject: "the
/// surface of the tooth".
[[nodiscard]] Expected<void> checkExtent(const TriangleMesh& mesh, const Message& what);

}  // namespace tactooth

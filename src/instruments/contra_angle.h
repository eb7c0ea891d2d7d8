// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A contra-angle handpiece for low speed with a latch, as a closed surface in the tool frame (origin at the bur's tip,
/// +z along the shaft, mm): its head around the shaft with the bur protruding, the handle leaving toward +x and upward,
/// wider than a turbine's, up to the motor's coupling. About `triangles` triangles, at most 24,000.
[[nodiscard]] TriangleMesh makeContraAngle(int triangles = 16000);

}  // namespace tactooth

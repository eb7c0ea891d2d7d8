// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A contra-angle handpiece with a latch on an electric motor, as a closed surface in the tool frame (origin at the tip
/// of the bur, +z along the shaft, mm): the head surrounds the shaft, the bur protrudes, and the handle leaves toward
/// +x and upward, wider than that of a turbine, up to the motor coupling. About `triangles` triangles, at most 24,000.
[[nodiscard]] TriangleMesh makeContraAngle(int triangles = 16000);

}  // namespace tactooth

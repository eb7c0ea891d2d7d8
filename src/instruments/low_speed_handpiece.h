// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A low-speed contra-angle on an air motor, as a closed surface in the tool frame (origin at the tip of the bur, +z
/// along the shaft, mm). Its head is larger than that of a turbine, because it holds a bur of 2.35 mm by a latch; the
/// neck is thick, and the handle ends in the motor. About `triangles` triangles, at most 24,000.
[[nodiscard]] TriangleMesh makeLowSpeedHandpiece(int triangles = 16000);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Corner of the profile: radius at a height, mm.
struct RevolutionProfilePoint {
    double radius;
    double z;
};

/// The profile of a mesh: for each height the largest distance from the z axis. Piecewise linear, never smaller than
/// the mesh, larger by less than 1 um. Empty if the mesh has no extent along z.
[[nodiscard]] std::vector<RevolutionProfilePoint> revolutionProfile(const TriangleMesh& mesh);

}  // namespace tactooth

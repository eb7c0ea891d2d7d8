// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// How a tool moves over the top (+z) of a tooth.
struct ToolTrajectory {
    double speed = 10;        ///< mm/s along the path
    double press = 0.3;       ///< mm that the device stays below the surface
    double approach = 0.5;    ///< mm above the tooth at the start and the end; negative: below the surface, inside
    double stroke = 4;        ///< mm: length of a slide across cusps and fissures
    int strokes = 4;          ///< back and forth, each 0.3 mm beside the last
    double turn = 60;         ///< degrees/s about the tip, back and forth
    double maxRotation = 20;  ///< degrees
};

/// The device pose at every millisecond: approach, press, slide, retract. The tip of the tool is its origin, its shaft
/// is along +z. Speed, stroke and rotation are positive.
[[nodiscard]] std::vector<Pose> toolTrajectory(const TriangleMesh& tooth, const ToolTrajectory& path);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/solid/distance_grid.h"
#include "geometry/util/pose.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {

/// What a virtual fixture does to the hand, as a spring does.
struct FixtureForce {
    Vec3 force = Vec3::Zero();  ///< on the device, N, tooth frame
    double beyond = 0;          ///< how far the spring is pressed, mm
    double energy = 0;          ///< in it, N*mm
};

/// A gentle guide for a hand that feels force: a virtual fixture (L. B. Rosenberg 1993) along the walls of the ideal
/// cavity. Where the bur goes beyond a wall, it is pushed back along the shortest displacement. The push can be
/// overcome. What is simulated and recorded is the tool of the hand: the guide changes what the hand feels, not what
/// the bur cuts. Does not change; does not allocate or lock.
class WallGuide {
public:
    /// `walls`: distances to the ideal tooth, negative inside, around its cavity, tooth frame; not null. `bur`: of the
    /// tool that is held.
    WallGuide(std::shared_ptr<const DistanceGrid> walls, const RevolutionEnvelope& bur);

    /// For a tool that the device holds at `tool`, tooth frame: nothing where the bur is beyond no wall, where it
    /// leaves the region of the walls, and for a pose that is not finite.
    [[nodiscard]] FixtureForce push(const Pose& tool) const;

    static constexpr double kStiffness = 0.6;  ///< N/mm: softer than the depth stop, and far softer than enamel
    static constexpr double kMostForce = 0.6;  ///< N: a careful hand works with 0.3 to 1 N

private:
    std::shared_ptr<const DistanceGrid> walls_;
    std::vector<Vec3> points_;  // on the bur, tool frame
};

/// Distances to the closed surface `ideal` around its cavity, which lies in `cavity`, for a guide. Takes up to a
/// second.
[[nodiscard]] DistanceGrid guideWalls(const SurfacePart& ideal, const Box3& cavity);

}  // namespace tactooth

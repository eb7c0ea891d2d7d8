// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "tooth/revolution_envelope.h"

namespace tactooth {

/// Nodes along one side of the blocks that are looked at together.
inline constexpr int kBlockSide = 4;
inline constexpr int kBlockNodes = kBlockSide * kBlockSide * kBlockSide;

/// Between which values the distance to a sweep lies at each node of a block (x + 4 y + 16 z), mm.
struct BlockBounds {
    std::array<float, kBlockNodes> lower;
    std::array<float, kBlockNodes> upper;
};

/// One short piece of a bur's motion, seen from the bur: within it a point of the tooth moves on a straight line of the
/// tool frame.
class SweepStep {
public:
    SweepStep(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth, double clearance);

    /// Distance from a point of the tooth frame to the region swept, with its gradient. Exact for an envelope whose
    /// distance is convex along the step (every convex bur); else too large by at most half the step's length.
    /// Once the distance is known to be `atLeast` or more, that lower bound is returned instead.
    [[nodiscard]] FieldSample sample(const Vec3& point, double atLeast) const;

    /// Lower bound of `sample` from one look at the profile, within the step's length of it.
    [[nodiscard]] double lowerBound(const Vec3& point) const;

    /// Bounds of `sample` for the block whose first node is `corner`: eight nodes at a time, without a search along the
    /// step.
    void boundBlock(const Vec3& corner, double spacing, BlockBounds& bounds) const;

    /// No point of the bur moves farther, mm.
    [[nodiscard]] double travel() const { return travel_; }

    /// What the step can have swept, in the tooth frame.
    [[nodiscard]] const Box3& box() const { return box_; }

private:
    struct Placed {
        Mat3 toothFromTool;
        Mat3 toolFromTooth;
        Vec3 position;
        [[nodiscard]] Vec3 toTool(const Vec3& point) const { return toolFromTooth * (point - position); }
    };
    const RevolutionEnvelope* envelope_;
    Placed from_;
    Placed to_;
    double clearance_;
    double travel_;
    Box3 box_;
};

/// The motion of a bur from one pose to another, translation and rotation, cut into steps short enough: at most
/// `longest` mm of travel, and so little turning that a straight path in the tool frame is true to 0.1 um.
[[nodiscard]] std::vector<SweepStep> sweepSteps(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                                const Pose& toInTooth, double clearance, double longest);

}  // namespace tactooth

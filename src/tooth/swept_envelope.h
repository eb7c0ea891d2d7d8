// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/revolution_envelope.h"

namespace tactooth {

/// One short piece of a bur's motion, seen from the bur: within it a point of the tooth moves on a straight line of the
/// tool frame.
class SweepStep {
public:
    SweepStep(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth, double clearance);

    /// Distance from a point of the tooth frame to the region swept, with its gradient. Exact for an envelope whose
    /// distance is convex along the step (every convex bur); else too large by at most half the step's length.
    /// Once the distance is known to be `atLeast` or more, that lower bound is returned instead.
    [[nodiscard]] FieldSample sample(const Vec3& point, double atLeast) const;

    /// One look at the profile, from where the step ends.
    struct Look {
        Vec3 pointInTool;
        double distance;
    };
    [[nodiscard]] Look lookFrom(const Vec3& point) const {
        const Vec3 pointInTool = to_.toTool(point);
        return {pointInTool, envelope_->signedDistance(pointInTool)};
    }
    /// Lower bound of `sample` from such a look, within the step's length of it.
    [[nodiscard]] double lowerBound(const Look& look) const { return look.distance - travel_ - clearance_; }
    [[nodiscard]] double lowerBound(const Vec3& point) const { return lowerBound(lookFrom(point)); }

    /// No point of the bur moves farther, mm.
    [[nodiscard]] double travel() const { return travel_; }

    /// What the step can have swept, in the tooth frame.
    [[nodiscard]] const Box3& box() const { return box_; }

private:
    friend class SweepLanes;
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

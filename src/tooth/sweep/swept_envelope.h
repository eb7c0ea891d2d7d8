// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {

/// One short piece of a bur's motion, seen from the bur: within it a point of the tooth moves on a straight line of the
/// tool frame.
class SweepStep {
public:
    /// `parts`: in how many equal ones the step is searched for its nearest time where the envelope has dents.
    SweepStep(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth, double clearance,
              int parts = 1);

    /// Distance from a point of the tooth frame to the region swept, with its gradient. Exact for an envelope whose
    /// distance is convex along each part (every convex bur); else too large by at most half a part's length.
    /// Once the distance is known to be `atLeast` or more, that lower bound is returned instead.
    [[nodiscard]] FieldSample sample(const Vec3& point, double atLeast) const;

    /// One look at the profile, from the middle of a point's way.
    struct MidpointQuery {
        Vec3 pointInTool;
        FieldSample sample;  ///< in the tool frame
        double path;         ///< of the point in the tool frame during the step, mm
    };
    [[nodiscard]] MidpointQuery queryFrom(const Vec3& point) const {
        TACTOOTH_ASSERT(point.allFinite());
        const auto [middle, path] = pathOf(point);
        return {middle, envelope_->sample(middle), path};
    }
    /// Lower bound of `sample` from such a query.
    [[nodiscard]] double lowerBound(const MidpointQuery& query) const {
        TACTOOTH_ASSERT(query.path >= 0 && !std::isnan(query.sample.distance));
        return query.sample.distance - query.path / 2 - clearance_;
    }
    [[nodiscard]] double lowerBound(const Vec3& point) const {
        const auto [middle, path] = pathOf(point);
        return envelope_->signedDistance(middle) - path / 2 - clearance_;
    }

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
    struct Nearest {
        FieldSample sample;  ///< in the tool frame
        double time;         ///< 0 at the step's start, 1 at its end
    };
    struct PointPath {
        Vec3 middle;  ///< in the tool frame
        double length;
    };
    [[nodiscard]] PointPath pathOf(const Vec3& point) const {
        const Vec3 start = from_.toTool(point);
        const Vec3 end = to_.toTool(point);
        return {(start + end) / 2, (end - start).norm()};
    }
    void searchPart(const Vec3& start, const Vec3& end, double first, double last, double limit, Nearest& best) const;

    const RevolutionEnvelope* envelope_;
    Placed from_;
    Placed to_;
    double clearance_;
    double travel_;
    int parts_;
    Box3 box_;
};

/// The motion of a bur from one pose to another, translation and rotation, cut into steps short enough: with so little
/// turning that a straight path in the tool frame is true to 0.1 um, and a few times `longest` mm of travel at most,
/// each searched in parts no longer than that.
[[nodiscard]] std::vector<SweepStep> sweepSteps(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                                const Pose& toInTooth, double clearance, double longest);

}  // namespace tactooth

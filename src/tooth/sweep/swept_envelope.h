// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/sweep/revolution_envelope.h"

namespace tactooth {

/// One short step of a bur's motion, seen from the bur. Within it a point of the tooth moves on a straight line of the
/// tool frame.
class SweepStep {
public:
    /// Poses are finite with unit rotations. `clearance` (mm) is not negative. `parts`: number of equal parts that are
    /// searched for the nearest time where the envelope has dents.
    SweepStep(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth, double clearance,
              int parts = 1);

    /// Distance from a point of the tooth frame to the swept region, with its gradient. It is exact for an envelope
    /// whose distance is convex along each part (every convex bur). Else it is too large by at most half the length of
    /// a part. Where the distance is `atLeast` or more, returns that lower bound.
    [[nodiscard]] FieldSample sample(const Vec3& point, double atLeast) const;

    /// One sample of the profile at the middle of a point's path.
    struct MidpointQuery {
        Vec3 pointInTool;
        FieldSample sample;  ///< in the tool frame
        double path;         ///< length of the point's path in the tool frame during the step, mm
    };
    [[nodiscard]] MidpointQuery queryFrom(const Vec3& point) const {
        TACTOOTH_ASSERT(point.allFinite());
        const auto [middle, path] = pathOf(point);
        return {middle, envelope_->sample(middle), path};
    }
    /// Lower bound of the distance that `sample` returns, from such a query, mm.
    [[nodiscard]] double lowerBound(const MidpointQuery& query) const {
        TACTOOTH_ASSERT(query.path >= 0 && !std::isnan(query.sample.distance));
        return query.sample.distance - query.path / 2 - clearance_;
    }
    [[nodiscard]] double lowerBound(const Vec3& point) const {
        const auto [middle, path] = pathOf(point);
        return envelope_->signedDistance(middle) - path / 2 - clearance_;
    }

    /// Upper bound of the displacement of all points of the bur, mm.
    [[nodiscard]] double travel() const { return travel_; }

    /// A box that holds the region that the step sweeps, tooth frame.
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

/// Divides the motion of a bur between two poses, translation and rotation, into steps. The rotation of a step is so
/// small that a straight path in the tool frame is exact to 0.1 um. A step travels at most a few times `longest` (mm)
/// and is searched in parts that are no longer than that.
[[nodiscard]] std::vector<SweepStep> sweepSteps(const RevolutionEnvelope& envelope, const Pose& fromInTooth,
                                                const Pose& toInTooth, double clearance, double longest);

}  // namespace tactooth

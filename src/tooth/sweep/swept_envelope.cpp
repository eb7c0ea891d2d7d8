// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/swept_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kStraightness = 1e-4;   ///< mm; sagitta of the arc of a rotating point within one step
constexpr double kDistanceError = 1e-5;  ///< mm; the search for the nearest time stops here
constexpr int kSearchRounds = 12;        ///< tangent cuts of the unit interval; three are usual
constexpr int kMaxParts = 4;             ///< of a step; a longer step comes near many bricks that it does not reach

/// Upper bound of the displacement of a point of the bur (a cylinder about its axis) between two poses.
double travelBetween(const RevolutionEnvelope& envelope, const Pose& from, const Pose& to) {
    const double angle = from.rotation.angularDistance(to.rotation);
    const auto axisTravel = [&](double z) { return (to * Vec3(0, 0, z) - from * Vec3(0, 0, z)).norm(); };
    return std::max(axisTravel(envelope.bottom()), axisTravel(envelope.top())) + angle * envelope.maxRadius();
}

Box3 boxAt(const RevolutionEnvelope& envelope, const Pose& pose, double clearance) {
    const Vec3 axis = pose.rotation * Vec3::UnitZ();
    const Vec3 reach = envelope.maxRadius() * (Vec3::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
    Box3 box;
    for (const double z : {envelope.bottom(), envelope.top()}) {
        const Vec3 centre = pose * Vec3(0, 0, z);
        box.extend(centre - reach - Vec3::Constant(clearance));
        box.extend(centre + reach + Vec3::Constant(clearance));
    }
    return box;
}

}  // namespace

SweepStep::SweepStep(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth,
                     double clearance, int parts)
    : envelope_(&envelope),
      clearance_(clearance),
      travel_(travelBetween(envelope, fromInTooth, toInTooth)),
      parts_(parts) {
    TACTOOTH_ASSERT(isRigid(fromInTooth) && isRigid(toInTooth));
    TACTOOTH_ASSERT(std::isfinite(clearance) && clearance >= 0);
    TACTOOTH_ASSERT(parts >= 1);
    const auto place = [](const Pose& pose) {
        const Mat3 rotation = pose.rotation.toRotationMatrix();
        return Placed{rotation, rotation.transpose(), pose.position};
    };
    from_ = place(fromInTooth);
    to_ = place(toInTooth);
    box_ = boxAt(envelope, fromInTooth, clearance).merged(boxAt(envelope, toInTooth, clearance));
    TACTOOTH_ASSERT(!box_.isEmpty());
    TACTOOTH_ASSERT(std::isfinite(travel_));
}

// Source: J. Kelley, "The Cutting-Plane Method for Solving Convex Programs", 1960, here on an interval. Along the
// straight path q(s), s in [0, 1], f(s) = distance(q(s)) is convex for a convex envelope. No tangent lies above f, and
// two tangents meet below the minimum. The search samples f where they meet and keeps the side on which f decreases.
void SweepStep::searchPart(const Vec3& start, const Vec3& end, double first, double last, double limit,
                           Nearest& best) const {
    TACTOOTH_ASSERT(first >= 0 && first < last && last <= 1);
    TACTOOTH_ASSERT(best.sample.distance <= limit);
    const auto take = [&](const FieldSample& sample, double time) {
        if (sample.distance < best.sample.distance) best = {sample, first + time * (last - first)};
    };
    FieldSample right = envelope_->sample(end);
    const Vec3 path = end - start;
    double rightSlope = right.gradient.dot(path);
    if (right.distance - std::max(0.0, rightSlope) >= limit) return;
    take(right, 1);
    if (rightSlope <= 0) return;
    FieldSample left = envelope_->sample(start);
    double leftSlope = left.gradient.dot(path);
    take(left, 0);
    double a = 0;
    double b = 1;
    for (int round = 0; round < kSearchRounds && leftSlope < 0; ++round) {
        const double time =
            (right.distance - left.distance + leftSlope * a - rightSlope * b) / (leftSlope - rightSlope);
        const double bound = left.distance + leftSlope * (time - a);
        if (bound >= limit || !(time > a && time < b) || best.sample.distance - bound < kDistanceError) return;
        const FieldSample middle = envelope_->sample(start + time * path);
        const double slope = middle.gradient.dot(path);
        take(middle, time);
        if (slope > 0) {
            b = time, right = middle, rightSlope = slope;
        } else {
            a = time, left = middle, leftSlope = slope;
        }
    }
}

FieldSample SweepStep::sample(const Vec3& point, double atLeast) const {
    TACTOOTH_ASSERT(point.allFinite());
    TACTOOTH_ASSERT(!std::isnan(atLeast));
    const double limit = atLeast + clearance_;
    Nearest best{{limit, Vec3::UnitZ()}, 1};
    const Vec3 start = from_.toTool(point);
    const Vec3 end = to_.toTool(point);
    if (envelope_->signedDistance(end) - (end - start).norm() < limit) {
        for (int part = parts_ - 1; part >= 0; --part) {
            const double first = static_cast<double>(part) / parts_;
            const double last = static_cast<double>(part + 1) / parts_;
            searchPart(start + first * (end - start), start + last * (end - start), first, last, limit, best);
        }
    }
    TACTOOTH_ASSERT(best.time >= 0 && best.time <= 1);
    const Placed& nearest = best.time < 0.5 ? from_ : to_;
    return {best.sample.distance - clearance_, nearest.toothFromTool * best.sample.gradient};
}

std::vector<SweepStep> sweepSteps(const RevolutionEnvelope& envelope, const Pose& fromInTooth, const Pose& toInTooth,
                                  double clearance, double longest) {
    TACTOOTH_ASSERT(isRigid(fromInTooth) && isRigid(toInTooth));
    TACTOOTH_ASSERT(std::isfinite(longest) && longest > 0);
    const double length = std::max(std::abs(envelope.bottom()), std::abs(envelope.top())) + envelope.maxRadius();
    const double largestTurn = std::sqrt(8 * kStraightness / length);
    const double travel = travelBetween(envelope, fromInTooth, toInTooth);
    const double angle = fromInTooth.rotation.angularDistance(toInTooth.rotation);
    const double shares = std::max(travel / (kMaxParts * longest), angle / largestTurn);
    TACTOOTH_ASSERT(shares >= 0 && shares < std::numeric_limits<int>::max());
    const int count = std::max(1, static_cast<int>(std::ceil(shares)));
    const int parts = std::max(1, static_cast<int>(std::ceil(travel / count / longest)));
    const auto at = [&](int i) {
        if (i == 0) return fromInTooth;
        if (i == count) return toInTooth;
        const double t = static_cast<double>(i) / count;
        return Pose{(1 - t) * fromInTooth.position + t * toInTooth.position,
                    fromInTooth.rotation.slerp(t, toInTooth.rotation)};
    };
    std::vector<SweepStep> steps;
    steps.reserve(count);
    for (int i = 0; i < count; ++i) steps.emplace_back(envelope, at(i), at(i + 1), clearance, parts);
    return steps;
}

}  // namespace tactooth

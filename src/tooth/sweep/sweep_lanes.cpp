// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/sweep_lanes.h"

#include <cmath>
#include <limits>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"

// The search of swept_envelope.cpp (J. Kelley, "The Cutting-Plane Method for Solving Convex Programs", 1960) for eight
// points at a time. Difference: single precision, with the segments of the profile that can be nearest to the points of
// a small cube.

namespace tactooth {
namespace {

constexpr float kDistanceError = 1e-5F;  ///< mm; the search for the nearest time stops here
constexpr int kSearchRounds = 12;        ///< tangent cuts of the unit interval; three are usual
constexpr double kPlaneError = 1e-5;     ///< mm; exceeds the rounding error of a plane's distance
/// mm; a shorter offset from a corner of the profile has no direction.
constexpr float kNoDirection = 1e-6F;
/// mm. Where two segments are almost collinear, rounding may choose the wrong one as the nearest. Such a point appears
/// to lie beyond the end of its segment, and the square of that excess is less than this times the distance.
constexpr float kBesideError = 1e-6F;
/// Share by which the region is enlarged, since its points are rounded.
constexpr double kRounding = 1e-6;

Vec3x8 turned(const Vec3x8& direction, const Mat3& rotation) {
    const auto along = [&](int axis) {
        return direction.x * Float8::all(static_cast<float>(rotation(axis, 0))) +
               direction.y * Float8::all(static_cast<float>(rotation(axis, 1))) +
               direction.z * Float8::all(static_cast<float>(rotation(axis, 2)));
    };
    return {along(0), along(1), along(2)};
}

}  // namespace

/// The distance of the envelope at eight points of the tool frame.
struct SweepLanes::Profile8 {
    Float8 distance;
    Vec3x8 gradient;
    [[nodiscard]] Float8 slope(const Vec3x8& path) const { return dot(gradient, path); }
};

SweepLanes::Frame SweepLanes::frame(const Vec3& first, const Mat3& steps, double level) {
    Frame frame;
    for (int axis = 0; axis < 3; ++axis) {
        frame.first[axis] = static_cast<float>(axis == 2 ? first.z() - level : first[axis]);
        for (int i = 0; i < 3; ++i) frame.steps[axis][i] = static_cast<float>(steps(axis, i));
    }
    return frame;
}

Vec3x8 SweepLanes::Frame::at(const Vec3x8& place) const {
    const auto along = [&](int axis) {
        return Float8::all(first[axis]) + place.x * Float8::all(steps[axis][0]) +
               place.y * Float8::all(steps[axis][1]) + place.z * Float8::all(steps[axis][2]);
    };
    return {along(0), along(1), along(2)};
}

SweepLanes::SweepLanes(const SweepStep& step, const Vec3& first, double spacing, double side, double beyond,
                       const SweepStep::MidpointQuery& middle)
    : step_(step), first_(first), spacing_(spacing) {
    TACTOOTH_ASSERT(first.allFinite());
    TACTOOTH_ASSERT(std::isfinite(spacing) && spacing > 0);
    TACTOOTH_ASSERT(side > 0 && beyond >= 0);
    TACTOOTH_ASSERT(middle.path >= 0);
    TACTOOTH_ASSERT(std::abs(middle.sample.gradient.squaredNorm() - 1) < 1e-6);
    const double reach = (0.5 * side * std::sqrt(3.0) + beyond) * spacing + middle.path / 2;
    hasPart_ = step.envelope_->findPart(middle.pointInTool, middle.sample.distance, reach * (1 + kRounding), part_);
    searchedParts_ = part_.bulges ? 1 : step.parts_;
    TACTOOTH_ASSERT(searchedParts_ >= 1);
    TACTOOTH_ASSERT(!hasPart_ || part_.pieceCount <= static_cast<int>(part_.pieces.size()));
    const auto planeOf = [&](const Vec3& firstInTool, const Mat3& steps) {
        const Vec3& normal = middle.sample.gradient;
        const double distance = middle.sample.distance + normal.dot(firstInTool - middle.pointInTool);
        const Vec3 growth = steps.transpose() * normal;
        return Plane{static_cast<float>(distance - step.clearance_ - kPlaneError),
                     {static_cast<float>(growth.x()), static_cast<float>(growth.y()), static_cast<float>(growth.z())}};
    };
    const auto place = [&](const SweepStep::Placed& pose, Frame& itsFrame, Plane& plane) {
        const Vec3 firstInTool = pose.toTool(first);
        const Mat3 steps = spacing * pose.toolFromTooth;
        itsFrame = frame(firstInTool, steps, middle.pointInTool.z());
        plane = planeOf(firstInTool, steps);
    };
    place(step.from_, from_, planeFrom_);
    place(step.to_, to_, planeTo_);
}

/// RevolutionEnvelope::sample for points of the region of `part_`.
SweepLanes::Profile8 SweepLanes::sampleProfile(const Vec3x8& point) const {
    const Float8 radius = sqrt(point.x * point.x + point.y * point.y);
    Float8 best = Float8::all(std::numeric_limits<float>::max());
    Float8 outside = zero8();
    Float8 beyond = zero8();
    Float8 directionR = zero8();
    Float8 directionZ = zero8();
    Float8 sides = zero8();
    for (int i = 0; i < part_.pieceCount; ++i) {
        const ProfilePart::Piece& piece = part_.pieces[i];
        const Float8 pieceR = Float8::all(piece.directionR);
        const Float8 pieceZ = Float8::all(piece.directionZ);
        const Float8 along = radius * pieceR + point.z * pieceZ + Float8::all(piece.along);
        const Float8 off = radius * pieceZ - point.z * pieceR + Float8::all(piece.outside);
        const Float8 over = along - min(max(along, zero8()), Float8::all(piece.length));
        const Float8 squared = off * off + over * over;
        outside = whereLess(squared, best, off, outside);
        beyond = whereLess(squared, best, over, beyond);
        directionR = whereLess(squared, best, pieceR, directionR);
        directionZ = whereLess(squared, best, pieceZ, directionZ);
        sides = whereLess(squared, best, Float8::all(piece.sides), sides);
        best = min(best, squared);
    }
    // Within a segment, the sign of the offset is the side, and the normal is that of the segment.
    Float8 distance = outside;
    Float8 slopeR = directionZ;
    Float8 slopeZ = zero8() - directionR;
    const Float8 isCorner = isLess(zero8(), beyond * beyond);
    if (isAny(isCorner)) {
        const Float8 atEnd = whereLess(sides, zero8(), Float8::all(-1), one8());
        const Float8 size = sqrt(best);
        const Float8 ofCorner = whereLess(beyond, zero8(), sides - atEnd - atEnd, atEnd);
        const Float8 ofPiece = whereLess(outside, zero8(), Float8::all(-1), one8());
        const Float8 side = whereLess(beyond * beyond, size * Float8::all(kBesideError), ofPiece, ofCorner);
        const Float8 hasDirection = isCorner * isLess(Float8::all(kNoDirection), size);
        const Float8 scale = side / max(size, Float8::all(kNoDirection));
        slopeR = choose(hasDirection, (beyond * directionR + outside * directionZ) * scale, slopeR);
        slopeZ = choose(hasDirection, (beyond * directionZ - outside * directionR) * scale, slopeZ);
        distance = choose(isCorner, side * size, distance);
    }
    const Float8 onAxis = isLess(radius, Float8::all(kNoDirection));
    const Float8 outward = slopeR / max(radius, Float8::all(kNoDirection));
    return {distance, {choose(onAxis, slopeR, outward * point.x), choose(onAxis, zero8(), outward * point.y), slopeZ}};
}

/// Used where the profile has too many segments near the cube.
Samples8 SweepLanes::sampleOneByOne(const Vec3x8& place, Float8 atLeast) const {
    float places[3][8];
    float limits[8];
    float distances[8];
    float gradients[3][8];
    place.store(places);
    atLeast.store(limits);
    for (int lane = 0; lane < 8; ++lane) {
        const Vec3 point = first_ + spacing_ * Vec3(places[0][lane], places[1][lane], places[2][lane]);
        const FieldSample sample = step_.sample(point, limits[lane]);
        TACTOOTH_ASSERT(std::isfinite(sample.distance) || std::isinf(limits[lane]));
        distances[lane] = static_cast<float>(sample.distance);
        for (int axis = 0; axis < 3; ++axis) gradients[axis][lane] = static_cast<float>(sample.gradient[axis]);
    }
    return {Float8::load(distances), Vec3x8::load(gradients)};
}

/// State of the search for eight points in a part of the step.
struct SweepLanes::Search {
    Float8 limit;      ///< only smaller distances count
    Float8 time;       ///< of the nearest point: 0 at the start of the step, 1 at its end
    Profile8 nearest;  ///< its distance is `limit` while nothing counts
};

// SweepStep::searchPart for eight lanes. A flag states which lanes are still searching.
void SweepLanes::searchPart(const Vec3x8& start, const Vec3x8& end, float first, float last, Search& search) const {
    TACTOOTH_ASSERT(first >= 0 && first < last && last <= 1);
    const auto take = [&](const Profile8& profile, Float8 time, Float8 flag) {
        const Float8 isBetter = flag * isLess(profile.distance, search.nearest.distance);
        search.nearest.distance = choose(isBetter, profile.distance, search.nearest.distance);
        search.nearest.gradient = choose(isBetter, profile.gradient, search.nearest.gradient);
        search.time = choose(isBetter, Float8::all(first) + time * Float8::all(last - first), search.time);
    };
    const Profile8 right = sampleProfile(end);
    const Vec3x8 path = end - start;
    Float8 rightDistance = right.distance;
    Float8 rightSlope = right.slope(path);
    take(right, one8(), one8());
    Float8 searching =
        isLess(zero8(), rightSlope) * isLess(rightDistance - rightSlope, min(search.limit, search.nearest.distance));
    if (!isAny(searching)) return;
    const Profile8 left = sampleProfile(start);
    Float8 leftDistance = left.distance;
    Float8 leftSlope = left.slope(path);
    take(left, zero8(), searching);
    searching = searching * isLess(leftSlope, zero8());
    Float8 a = zero8();
    Float8 b = one8();
    for (int round = 0; round < kSearchRounds && isAny(searching); ++round) {
        const Float8 meeting =
            (rightDistance - leftDistance + leftSlope * a - rightSlope * b) / (leftSlope - rightSlope);
        const Float8 time = min(max(meeting, a), b);  // almost equal slopes meet at a place that rounding decides
        const Float8 bound = leftDistance + leftSlope * (time - a);
        searching = searching * isLess(a, time) * isLess(time, b) *
                    isLess(bound + Float8::all(kDistanceError), search.nearest.distance);
        if (!isAny(searching)) break;
        const Profile8 middle =
            sampleProfile({start.x + time * path.x, start.y + time * path.y, start.z + time * path.z});
        const Float8 slope = middle.slope(path);
        take(middle, time, searching);
        const Float8 rises = searching * isLess(zero8(), slope);
        const Float8 falls = searching - rises;
        b = choose(rises, time, b);
        rightDistance = choose(rises, middle.distance, rightDistance);
        rightSlope = choose(rises, slope, rightSlope);
        a = choose(falls, time, a);
        leftDistance = choose(falls, middle.distance, leftDistance);
        leftSlope = choose(falls, slope, leftSlope);
    }
}

Samples8 SweepLanes::sample(const Vec3x8& place, Float8 atLeast) const {
    TACTOOTH_ASSERT((lessEqual(atLeast, atLeast) & 0xFFU) == 0xFFU);  // no lane is NaN
    if (!hasPart_) return sampleOneByOne(place, atLeast);
    const Float8 clearance = Float8::all(static_cast<float>(step_.clearance_));
    const Vec3x8 start = from_.at(place);
    const Vec3x8 end = to_.at(place);
    Search search{atLeast + clearance, one8(), {atLeast + clearance, Vec3x8::all(0, 0, 1)}};
    if (searchedParts_ == 1) {
        searchPart(start, end, 0, 1, search);
    } else {
        const Vec3x8 path = end - start;
        const auto at = [&](float time) {
            const Float8 share = Float8::all(time);
            return Vec3x8{start.x + share * path.x, start.y + share * path.y, start.z + share * path.z};
        };
        for (int part = searchedParts_ - 1; part >= 0; --part) {
            const float first = static_cast<float>(part) / static_cast<float>(searchedParts_);
            const float last = static_cast<float>(part + 1) / static_cast<float>(searchedParts_);
            searchPart(at(first), at(last), first, last, search);
        }
    }
    const Float8 isFound = isLess(search.nearest.distance, search.limit);
    Vec3x8 gradient = turned(search.nearest.gradient, step_.to_.toothFromTool);
    const Float8 isEarly = isLess(search.time, Float8::all(0.5F));
    if (isAny(isEarly)) {
        gradient = choose(isEarly, turned(search.nearest.gradient, step_.from_.toothFromTool), gradient);
    }
    return {choose(isFound, search.nearest.distance - clearance, atLeast), gradient};
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep_lanes.h"

#include <cmath>
#include <limits>

#include "collision/lane_flags.h"

namespace tactooth {
namespace {

constexpr float kDistanceError = 1e-5F;  ///< mm; where the search for the nearest moment stops
constexpr int kSearchRounds = 12;        ///< tangent cuts on a unit interval; three are usual
/// mm; nearer than this the offset to a corner of the profile has no direction.
constexpr float kNoDirection = 1e-6F;
/// Share by which a region is looked at wider: its points are rounded.
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

/// The envelope's distance at eight points of the tool frame.
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
                       const SweepStep::Look& middle)
    : step_(step), first_(first), spacing_(spacing) {
    const double reach = (0.5 * side * std::sqrt(3.0) + beyond) * spacing + step.travel_;
    hasPart_ = step.envelope_->findPart(middle.pointInTool, middle.distance, reach * (1 + kRounding), part_);
    from_ = frame(step.from_.toTool(first), spacing * step.from_.toolFromTooth, middle.pointInTool.z());
    to_ = frame(step.to_.toTool(first), spacing * step.to_.toolFromTooth, middle.pointInTool.z());
}

/// RevolutionEnvelope::sample for points of the region that `part_` was found for.
SweepLanes::Profile8 SweepLanes::sampleProfile(const Vec3x8& point) const {
    const Float8 radius = sqrt(point.x * point.x + point.y * point.y);
    Float8 best = Float8::all(std::numeric_limits<float>::max());
    Float8 offsetR = zero8();
    Float8 offsetZ = zero8();
    Float8 directionR = zero8();
    Float8 directionZ = zero8();
    Float8 beyondEnd = zero8();
    for (int i = 0; i < part_.pieceCount; ++i) {
        const ProfilePart::Piece& piece = part_.pieces[i];
        const Float8 pieceR = Float8::all(piece.directionR);
        const Float8 pieceZ = Float8::all(piece.directionZ);
        const Float8 dr = radius - Float8::all(piece.radius);
        const Float8 dz = point.z - Float8::all(piece.z);
        const Float8 place = dr * pieceR + dz * pieceZ;
        const Float8 along = min(max(place, zero8()), Float8::all(piece.length));
        const Float8 awayR = dr - along * pieceR;
        const Float8 awayZ = dz - along * pieceZ;
        const Float8 squared = awayR * awayR + awayZ * awayZ;
        offsetR = whereLess(squared, best, awayR, offsetR);
        offsetZ = whereLess(squared, best, awayZ, offsetZ);
        directionR = whereLess(squared, best, pieceR, directionR);
        directionZ = whereLess(squared, best, pieceZ, directionZ);
        beyondEnd = whereLess(squared, best, place - along, beyondEnd);
        best = min(best, squared);
    }
    const Float8 distance = sqrt(best);
    // Nearest within a piece, a point lies on the side to which its offset points, and has the piece's normal.
    Float8 sign = whereLess(offsetR * directionZ, offsetZ * directionR, Float8::all(-1), one8());
    Float8 slopeR = directionZ;
    Float8 slopeZ = zero8() - directionR;
    const Float8 isCorner = isLess(zero8(), beyondEnd * beyondEnd);
    if (isAny(isCorner)) {
        Float8 outside = one8();
        for (int i = 0; i < part_.spanCount; ++i) {
            const ProfilePart::Span& span = part_.spans[i];
            const Float8 above = point.z - Float8::all(span.low);
            const Float8 beyond = radius - (Float8::all(span.radius) + above * Float8::all(span.growth));
            // A point at the very height where two spans meet belongs to both.
            const Float8 isBeside =
                isLess(Float8::all(kNoDirection), max(zero8() - above, point.z - Float8::all(span.high)));
            outside = min(outside, choose(isBeside, one8(), beyond));
        }
        sign = choose(isCorner, whereLess(outside, zero8(), Float8::all(-1), one8()), sign);
        const Float8 hasDirection = isLess(Float8::all(kNoDirection), distance) * isCorner;
        const Float8 scale = sign / max(distance, Float8::all(kNoDirection));
        slopeR = choose(hasDirection, offsetR * scale, slopeR);
        slopeZ = choose(hasDirection, offsetZ * scale, slopeZ);
    }
    const Float8 onAxis = isLess(radius, Float8::all(kNoDirection));
    const Float8 outward = slopeR / max(radius, Float8::all(kNoDirection));
    return {sign * distance,
            {choose(onAxis, slopeR, outward * point.x), choose(onAxis, zero8(), outward * point.y), slopeZ}};
}

/// Where the profile has too many pieces near the cube.
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
        distances[lane] = static_cast<float>(sample.distance);
        for (int axis = 0; axis < 3; ++axis) gradients[axis][lane] = static_cast<float>(sample.gradient[axis]);
    }
    return {Float8::load(distances), Vec3x8::load(gradients)};
}

// The search of SweepStep::sample, lane by lane: a flag tells which lanes still take part.
Samples8 SweepLanes::sample(const Vec3x8& place, Float8 atLeast) const {
    if (!hasPart_) return sampleOneByOne(place, atLeast);
    const Float8 clearance = Float8::all(static_cast<float>(step_.clearance_));
    const Float8 limit = atLeast + clearance;
    const Vec3x8 end = to_.at(place);
    Profile8 best = sampleProfile(end);
    Float8 counts = isLess(best.distance - Float8::all(static_cast<float>(step_.travel_)), limit);
    if (!isAny(counts)) return {atLeast, best.gradient};

    const Vec3x8 start = from_.at(place);
    const Vec3x8 path = end - start;
    Float8 rightDistance = best.distance;
    Float8 rightSlope = best.slope(path);
    counts = counts * isLess(rightDistance - max(zero8(), rightSlope), limit);
    Float8 searching = counts * isLess(zero8(), rightSlope);
    Float8 bestMoment = one8();
    if (isAny(searching)) {
        const Profile8 first = sampleProfile(start);
        Float8 leftDistance = first.distance;
        Float8 leftSlope = first.slope(path);
        const auto take = [&](const Profile8& profile, Float8 moment) {
            const Float8 isBetter = searching * isLess(profile.distance, best.distance);
            best.distance = choose(isBetter, profile.distance, best.distance);
            best.gradient = choose(isBetter, profile.gradient, best.gradient);
            bestMoment = choose(isBetter, moment, bestMoment);
        };
        take(first, zero8());
        searching = searching * isLess(leftSlope, zero8());
        Float8 a = zero8();
        Float8 b = one8();
        for (int round = 0; round < kSearchRounds && isAny(searching); ++round) {
            const Float8 meeting =
                (rightDistance - leftDistance + leftSlope * a - rightSlope * b) / (leftSlope - rightSlope);
            const Float8 moment = min(max(meeting, a), b);  // all but equal slopes meet where rounding will have it
            const Float8 bound = leftDistance + leftSlope * (moment - a);
            counts = choose(searching, isLess(bound, limit), counts);
            searching = searching * counts * isLess(a, moment) * isLess(moment, b) *
                        isLess(bound + Float8::all(kDistanceError), best.distance);
            if (!isAny(searching)) break;
            const Profile8 middle =
                sampleProfile({start.x + moment * path.x, start.y + moment * path.y, start.z + moment * path.z});
            const Float8 slope = middle.slope(path);
            take(middle, moment);
            const Float8 rises = searching * isLess(zero8(), slope);
            const Float8 falls = searching - rises;
            b = choose(rises, moment, b);
            rightDistance = choose(rises, middle.distance, rightDistance);
            rightSlope = choose(rises, slope, rightSlope);
            a = choose(falls, moment, a);
            leftDistance = choose(falls, middle.distance, leftDistance);
            leftSlope = choose(falls, slope, leftSlope);
        }
    }
    Vec3x8 gradient = turned(best.gradient, step_.to_.toothFromTool);
    const Float8 isEarly = isLess(bestMoment, Float8::all(0.5F));
    if (isAny(isEarly)) gradient = choose(isEarly, turned(best.gradient, step_.from_.toothFromTool), gradient);
    return {choose(counts, best.distance - clearance, atLeast), gradient};
}

}  // namespace tactooth

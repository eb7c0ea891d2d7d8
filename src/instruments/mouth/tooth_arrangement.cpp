// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// A tooth erupts until it meets its neighbours and its opponents. The algorithm does the same: each tooth is pushed
// along the arch up to the one before it, and each upper one down to the lower ones. Inclinations of the long axes:
// textbook drawings (crowns of molars lean to the tongue below and to the cheek above, those of incisors to the lips).
#include "instruments/mouth/tooth_arrangement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "collision/bvh/closest_point.h"
#include "geometry/util/degree.h"
#include "geometry/util/parallel_for.h"
#include "instruments/builtin_tooth.h"

namespace tactooth {
namespace {

/// Inclination of a tooth in the arch: degrees, mm.
struct ToothInclination {
    double tip;      ///< crown to mesial
    double torque;   ///< crown to the lips or cheek
    double turn;     ///< mesial side to the cheek
    double outward;  ///< offset of its point on the line of occlusion
};

constexpr std::array<ToothInclination, kTeethPerQuadrant> kUpper = {{{1, 18, -6, 0.4},
                                                                     {4, 17, 0, 0.4},
                                                                     {8, 9, 0, 0.4},
                                                                     {3, 2, 0, 0.2},
                                                                     {2, 2, 0, 0.1},
                                                                     {2, 5, 8, 0.0},
                                                                     {0, 7, 6, 0.0},
                                                                     {-4, 8, 4, 0.0}}};
constexpr std::array<ToothInclination, kTeethPerQuadrant> kLower = {{{0, 6, 0, 0},
                                                                     {0, 6, 0, 0},
                                                                     {4, 4, 0, 0},
                                                                     {3, -3, 0, 0},
                                                                     {4, -6, 0, 0},
                                                                     {5, -10, 0, 0},
                                                                     {7, -13, 0, 0},
                                                                     {9, -14, 0, 0}}};

/// A tooth as a surface for distance queries.
struct ToothSurface {
    ToothShape shape;
    SurfacePart surface;
    Vec3 onLine = Vec3::Zero();  ///< the point that belongs on the line of occlusion, shape frame
    double halfWidth = 0;        ///< mesiodistal
};

constexpr double kCell = 0.33;  // mm: the mesh is within 0.02 mm of the surface

ToothSurface toothSurfaceOf(int fdi, std::uint32_t seed) {
    ToothShape shape = toothShape(fdi, seed);
    SurfacePart surface(
        isosurface(shape.outer, shape.bounds, {.cellSize = kCell, .lipschitzBound = 1.3, .relaxations = 1}));
    ToothSurface tooth{std::move(shape), std::move(surface)};
    Box3 crown;
    for (const Vec3f& v : tooth.surface.mesh().vertices) {
        if (v.z() > 0) crown.extend(v.cast<double>());
    }
    tooth.halfWidth = crown.sizes().x() / 2;
    const bool upper = fdi < 30, front = isAnteriorTooth(fdi);
    if (!upper) {  // the edge, or the buccal cusps
        Vec3 top(0, 0, -1e9);
        for (const Vec3f& v : tooth.surface.mesh().vertices) {
            if ((front || v.y() > 0) && v.z() > top.z()) top = v.cast<double>();
        }
        constexpr double kCanine = 0.9;  // mm that the tips of the canines are above the other edges
        tooth.onLine = Vec3(0, top.y(), top.z() - (fdi % 10 == 3 ? kCanine : 0));
    } else if (front) {  // the palatal face, an overbite above the edge
        constexpr double kOverbite = 2.6, kStep = 0.02;
        Vec3 point(0, crown.min().y() - 1, crown.max().z() - kOverbite);
        while (tooth.shape.outer(point) > 0 && point.y() < crown.max().y()) point.y() += kStep;
        tooth.onLine = point;
    } else {  // the fossae
        constexpr double kBuccal = 0.3, kBelowCusps = 2.2;
        tooth.onLine = Vec3(0, kBuccal, crown.max().z() - kBelowCusps);
    }
    return tooth;
}

/// The closest points of two teeth; the distance is negative where they overlap.
struct Nearest {
    double distance;
    Vec3 at = Vec3::Zero();
};

/// Updates `nearest` if a vertex of `from` is closer to `to`; `at` is in the frame of `to`.
template <class ToFrame>
void measureFrom(const SurfacePart& from, const SurfacePart& to, const ToFrame& toFrame, Nearest& nearest) {
    constexpr double kDeep = 1.0;  // mm: depth up to which an inner vertex is measured
    Box3 reach = to.tree().box();
    reach.min().array() -= nearest.distance;
    reach.max().array() += nearest.distance;
    for (const Vec3f& v : from.mesh().vertices) {
        const Vec3 point = toFrame(v.cast<double>());
        if (!reach.contains(point)) continue;
        const auto near = closestPoint(to, point, std::max(nearest.distance, kDeep));
        if (!near) continue;
        const double distance = contains(to, point) ? -near->distance : near->distance;
        if (distance < nearest.distance) nearest = {distance, (point + near->point) / 2};
    }
}

Nearest nearestBetween(const ToothSurface& a, const Pose& aInMouth, const ToothSurface& b, const Pose& bInMouth,
                       double far) {
    const Pose bInA = aInMouth.inverse() * bInMouth, aInB = bInA.inverse();
    Nearest nearest{far};
    measureFrom(
        b.surface, a.surface, [&](const Vec3& p) { return bInA * p; }, nearest);
    nearest.at = aInMouth * nearest.at;
    Nearest other{nearest.distance};
    measureFrom(
        a.surface, b.surface, [&](const Vec3& p) { return aInB * p; }, other);
    if (other.distance < nearest.distance) nearest = {other.distance, bInMouth * other.at};
    return nearest;
}

constexpr double kFar = 0.6;  // mm: beyond it, distances do not matter

/// Random inclinations of one patient, the same for both sides.
class InclinationVariation {
public:
    InclinationVariation(std::uint32_t seed, bool upper) : random_(2 * seed + (upper ? 1 : 0)), isAverage_(seed == 0) {}
    ToothInclination operator()(ToothInclination inclination) {
        inclination.tip += deviation(2.0);
        inclination.torque += deviation(1.5);
        inclination.turn += deviation(3.0);
        return inclination;
    }

private:
    double deviation(double range) {
        constexpr double kHalf = 2147483648.0;
        const double value = range * (static_cast<double>(random_()) / kHalf - 1);
        return isAverage_ ? 0 : value;
    }
    std::mt19937 random_;
    bool isAverage_;
};

/// The pose of a tooth with its point on the line at `s`.
Pose poseAt(const ArchCurve& line, double s, bool upper, const ToothInclination& inclination, const Vec3& onLine) {
    const ArchCurve::Place place = line.at(upper ? s : -s);
    const Vec3 mesial = upper ? Vec3(-place.along) : place.along;
    const double depth = -place.point.y();
    Mat3 axes;
    axes << mesial, place.outward, mesial.cross(place.outward);
    constexpr double kStep = 0.1;  // mm
    const double rise = (occlusalPlane(depth + kStep) - occlusalPlane(depth)) / kStep;
    // Posterior teeth are perpendicular to the occlusal surface, which rises backward.
    const double back = std::atan(rise) * std::max(0.0, mesial.y()) * (upper ? -1 : 1);
    const Quat lean = Quat(Eigen::AngleAxisd(inclination.turn * kDegree, Vec3::UnitZ())) *
                      Quat(Eigen::AngleAxisd(inclination.tip * kDegree + back, Vec3::UnitY())) *
                      Quat(Eigen::AngleAxisd(-inclination.torque * kDegree, Vec3::UnitX()));
    const Quat rotation = (Quat(axes) * lean).normalized();
    // The upper arch is so far forward that the mesiobuccal cusps of its first molars meet the buccal grooves below.
    const Vec3 forward = (upper ? 1.5 : 0.0) * Vec3::UnitY();
    const Vec3 point =
        place.point + forward + inclination.outward * place.outward + occlusalPlane(depth) * Vec3::UnitZ();
    return {point - rotation * onLine, rotation};
}

/// The first value at which `distance`, which grows, is at least `gap`.
template <class Distance>
double firstWith(double gap, double from, double to, const Distance& distance) {
    constexpr int kHalvings = 14;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (from + to) / 2;
        (distance(middle) < gap ? from : to) = middle;
    }
    return to;
}

using ToothSurfaces = std::array<ToothSurface, kTeethPerQuadrant>;
using ToothInclinations = std::array<ToothInclination, kTeethPerQuadrant>;
using Heights = std::array<double, kTeethPerQuadrant>;  // mm above the usual position

ToothSurfaces toothSurfacesOf(int quadrant, std::uint32_t seed) {
    std::array<std::optional<ToothSurface>, kTeethPerQuadrant> made;
    parallelFor(kTeethPerQuadrant,
                [&](std::size_t i) { made[i] = toothSurfaceOf(10 * quadrant + static_cast<int>(i) + 1, seed); });
    return [&]<std::size_t... I>(std::index_sequence<I...>) { return ToothSurfaces{std::move(*made[I])...}; }
    (std::make_index_sequence<kTeethPerQuadrant>());
}

/// A central incisor and its mirror image. Their faces are nearly straight, so that they touch along a line: `at` is
/// the middle of it, not its one end or the other.
Nearest nearestToMirror(const ToothSurface& tooth, const Pose& pose, bool onTheRight) {
    constexpr double kAlmost = 0.1;  // mm more than the least distance
    const auto apart = [onTheRight](const Vec3& point) { return 2 * (onTheRight ? point.x() : -point.x()); };
    Nearest nearest{1e9};
    for (const Vec3f& v : tooth.surface.mesh().vertices)
        nearest.distance = std::min(nearest.distance, apart(pose * v.cast<double>()));
    Box3 line;
    for (const Vec3f& v : tooth.surface.mesh().vertices) {
        const Vec3 point = pose * v.cast<double>();
        if (apart(point) < nearest.distance + kAlmost) line.extend(Vec3(0, point.y(), point.z()));
    }
    nearest.at = line.center();
    return nearest;
}

/// Pushes each tooth along the line up to the one before it.
void placeAlong(const ArchCurve& line, const ToothSurfaces& surfaces, const ToothInclinations& inclinations,
                const Heights& heights, JawQuadrant& side) {
    double s = 0;
    for (std::size_t i = 0; i < kTeethPerQuadrant; ++i) {
        const ToothSurface& tooth = surfaces[i];
        const auto pose = [&](double at) {
            Pose placed = poseAt(line, at, side.upper, inclinations[i], tooth.onLine);
            placed.position.z() += heights[i];
            return placed;
        };
        const auto nearest = [&](double at) {
            if (i == 0) return nearestToMirror(tooth, pose(at), side.upper);
            return nearestBetween(surfaces[i - 1], side.teeth[i - 1].shapeInMouth, tooth, pose(at), kFar);
        };
        constexpr double kLeast = 0.5, kMost = 1.35;  // of the step that two straight teeth side by side would need
        const double step = i > 0 ? surfaces[i - 1].halfWidth + tooth.halfWidth : tooth.halfWidth;
        s = firstWith(kContactGap, s + kLeast * step, s + kMost * step,
                      [&](double at) { return nearest(at).distance; });
        side.teeth[i] = {tooth.shape, pose(s)};
        const Nearest contact = nearest(s);
        side.contacts[i] = {contact.at, contact.distance};
    }
}

/// Distance of upper tooth `i`, raised by `up`, from the lower teeth.
double clearance(const ToothArrangement& places, const ToothSurfaces& upper, const ToothSurfaces& lower, std::size_t i,
                 double up) {
    const Pose& tooth = places.upper.teeth[i].shapeInMouth;
    const Pose raised{tooth.position + up * Vec3::UnitZ(), tooth.rotation};
    Nearest nearest{kFar};
    for (std::size_t k = i > 1 ? i - 2 : 0; k < std::min<std::size_t>(i + 3, kTeethPerQuadrant); ++k) {
        const Pose mouthInLower = places.lower.teeth[k].shapeInMouth.inverse();
        // The lower teeth are on the left: the mirror image of the upper one meets them.
        const auto toLower = [&](const Vec3& p) -> Vec3 {
            const Vec3 q = raised * p;
            return mouthInLower * Vec3(-q.x(), q.y(), q.z());
        };
        measureFrom(upper[i].surface, lower[k].surface, toLower, nearest);
    }
    return nearest.distance;
}

/// Raises or lowers each upper tooth from its position so that it just meets a lower one.
void bite(const ToothArrangement& places, const ToothSurfaces& upper, const ToothSurfaces& lower, Heights& heights) {
    // mm from the usual position. Anterior teeth keep their overbite, whether they meet the lower ones or not.
    constexpr double kLowestFront = -0.3, kLowest = -3.0, kHighest = 4.0;
    Heights met = heights;
    parallelFor(kTeethPerQuadrant, [&](std::size_t i) {
        const double lowest = i < 3 ? kLowestFront : kLowest;
        met[i] += firstWith(kOcclusalGap, lowest - heights[i], kHighest - heights[i],
                            [&](double up) { return clearance(places, upper, lower, i, up); });
    });
    heights = met;
}

/// Opens the bite by the overlap that pushing the teeth together again has made.
void part(ToothArrangement& places, const ToothSurfaces& upper, const ToothSurfaces& lower) {
    constexpr double kMost = 1.0;  // mm
    Heights up{};
    parallelFor(kTeethPerQuadrant, [&](std::size_t i) {
        up[i] =
            firstWith(kOcclusalGap, 0, kMost, [&](double shift) { return clearance(places, upper, lower, i, shift); });
    });
    const double shift = *std::ranges::max_element(up);
    for (PlacedShape& tooth : places.upper.teeth) tooth.shapeInMouth.position.z() += shift;
    for (ProximalContact& contact : places.upper.contacts) contact.point.z() += shift;
}

ToothInclinations inclinationsOf(bool upper, std::uint32_t seed) {
    InclinationVariation variation(seed, upper);
    ToothInclinations inclinations;
    std::ranges::transform(upper ? kUpper : kLower, inclinations.begin(), variation);
    return inclinations;
}

}  // namespace

Pose mirroredInX(const Pose& pose) {
    const Quat& q = pose.rotation;
    return {Vec3(-pose.position.x(), pose.position.y(), pose.position.z()), Quat(q.w(), q.x(), -q.y(), -q.z())};
}

ToothArrangement arrangeTeeth(std::uint32_t seed) {
    const ToothSurfaces upper = toothSurfacesOf(1, seed), lower = toothSurfacesOf(3, seed);
    const ToothInclinations upperInclinations = inclinationsOf(true, seed);
    ToothArrangement places;
    places.upper.upper = true;
    placeAlong(places.line, lower, inclinationsOf(false, seed), {}, places.lower);
    Heights heights{};
    constexpr int kRounds = 2;  // teeth at other heights touch at other points
    for (int round = 0; round < kRounds; ++round) {
        placeAlong(places.line, upper, upperInclinations, heights, places.upper);
        bite(places, upper, lower, heights);
    }
    placeAlong(places.line, upper, upperInclinations, heights, places.upper);
    part(places, upper, lower);
    return places;
}

}  // namespace tactooth

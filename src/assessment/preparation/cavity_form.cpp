// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/cavity_form.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/gauge/floor_places.h"
#include "assessment/messages.h"
#include "assessment/preparation/quantile.h"
#include "geometry/util/degree.h"
#include "geometry/util/parallel_for.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

const double kWallCosine = std::sin(45 * kDegree);  // a wall is nearer to the axis than to its normal plane
constexpr double kAxialCosine = 0.5;                // of a crown preparation: steeper than a cusp's bevel
constexpr double kRounding = 0.3;                   // mm: strip along the border with the rounded angles
constexpr double kLeastWall = 0.5;                  // mm^2: smaller walls are not judged
constexpr double kLeastInner = 0.05;                // mm^2 within the border, for a direction worth the name

struct FloorDepth {
    double depth;  // mm
    Vec3 place;
};

struct FloorPlane {
    Vec3 centre, normal;  // mm; unit, out of the tooth
    double rms;           // distance of the places, mm
};

/// By total least squares; all places count alike.
FloorPlane planeThrough(const std::vector<Vec3>& places, const Vec3& axis) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& place : places) mean += place / static_cast<double>(places.size());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& place : places)
        spread += (place - mean) * (place - mean).transpose() / static_cast<double>(places.size());
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    const Vec3 normal = axes.eigenvectors().col(0);
    return {mean, normal.dot(axis) < 0 ? Vec3(-normal) : normal, std::sqrt(std::max(0.0, axes.eigenvalues()[0]))};
}

std::vector<FloorDepth> depthsOf(const Preparation& preparation, const std::vector<Vec3>& floor) {
    constexpr std::size_t kGrain = 256;  // rays
    std::vector<FloorDepth> depths(floor.size());
    parallelFor(
        floor.size(),
        [&](std::size_t i) {
            depths[i] = {depthInside(*preparation.original, floor[i], preparation.axis), floor[i]};
        },
        kGrain);
    std::ranges::stable_sort(depths, {}, &FloorDepth::depth);
    return depths;
}

void measureFloor(const Preparation& preparation, const CutSurfaces& surfaces, CavityForm& form) {
    const std::vector<Vec3> floor = floorPlaces(surfaces.cut.mesh, preparation.axis);
    if (floor.empty()) {
        const MessageText& reason = surfaces.facets.empty() ? msg::kNothingCut : msg::kNoFloor;
        for (Measured* each : {&form.floorDepth, &form.floorDepthMin, &form.floorDepthP5, &form.floorDepthP95,
                               &form.floorDepthMax, &form.floorFlatness, &form.floorTilt})
            *each = Measured::none(reason);
        return;
    }
    const FloorPlane plane = planeThrough(floor, preparation.axis);
    form.floorFlatness = Measured::at(plane.rms, plane.centre);
    form.floorTilt =
        Measured::at(std::acos(std::clamp(plane.normal.dot(preparation.axis), -1.0, 1.0)) / kDegree, plane.centre);
    const std::vector<FloorDepth> depths = depthsOf(preparation, floor);
    const auto at = [&](double share) {
        const auto all = static_cast<double>(depths.size());
        const FloorDepth& found = quantileByArea(depths, all, share, [](const FloorDepth&) { return 1; });
        return Measured::at(found.depth, found.place);
    };
    const std::size_t count = depths.size();  // of an even number the median lies between the middle two
    form.floorDepth = Measured::at((depths[(count - 1) / 2].depth + depths[count / 2].depth) / 2, plane.centre);
    form.floorDepthMin = at(0);
    form.floorDepthP5 = at(0.05);
    form.floorDepthP95 = at(0.95);
    form.floorDepthMax = at(1);
}

/// Of the walls of a crown preparation the part next to the finish line: farther up begin the planes that follow cusps
/// and edge.
CutPatch axialPart(const Preparation& preparation, const CutSurfaces& surfaces, const CutPatch& walls) {
    constexpr double kAxialHeight = 1.5;  // mm above the finish line
    constexpr std::size_t kSectors = 48;  // around the axis, in which the finish line has one height
    const Vec3 u = preparation.axis.unitOrthogonal(), v = preparation.axis.cross(u);
    const auto sectorOf = [&](const Vec3& place) {
        const Vec3 from = place - surfaces.middle;
        const double turn = std::atan2(v.dot(from), u.dot(from)) / (2 * std::numbers::pi) + 0.5;
        return std::min(kSectors - 1, static_cast<std::size_t>(turn * kSectors));
    };
    std::array<double, kSectors> sums{}, counts{};
    for (const auto& [from, to] : surfaces.cut.rim) {
        const Vec3 place = surfaces.cut.mesh.vertices[from].cast<double>();
        sums[sectorOf(place)] += preparation.axis.dot(place);
        counts[sectorOf(place)] += 1;
    }
    CutPatch part;
    for (const std::uint32_t i : walls) {
        const Vec3& place = surfaces.facets[i].centre;
        std::size_t sector = sectorOf(place);
        for (std::size_t k = 0; k < kSectors && counts[sector] == 0; ++k) sector = (sector + 1) % kSectors;
        const double line = counts[sector] > 0 ? sums[sector] / counts[sector] : 0;
        if (counts[sector] == 0 || preparation.axis.dot(place) < line + kAxialHeight) part.push_back(i);
    }
    return part;
}

/// The mean angle of the facets of `walls` on one side to the axis, degrees. Adds those that were measured to
/// `measured`.
Measured wallAngle(const Preparation& preparation, const CutSurfaces& surfaces, const CutPatch& walls, const Vec3& side,
                   CutPatch& measured) {
    // The normal of a cavity's wall points away from its side, that of a stump toward it.
    const Vec3 facing = surfaces.isCrown ? side : Vec3(-side);
    CutPatch wall;
    for (const std::uint32_t i : walls) {
        const Vec3& normal = surfaces.facets[i].normal;
        const Vec3 level = normal - normal.dot(preparation.axis) * preparation.axis;
        if (level.normalized().dot(facing) > std::cos(45 * kDegree)) wall.push_back(i);
    }
    if (areaOf(surfaces, wall) < kLeastWall) return Measured::none(msg::kWallTooSmall);
    // An uneven hand leaves places that do not count as wall: with their borders, little may be left.
    CutPatch inner = withoutBorder(surfaces, wall, kRounding);
    if (areaOf(surfaces, inner) < kLeastInner) inner = withoutBorder(surfaces, wall, kRounding / 2);
    const double area = areaOf(surfaces, inner);
    if (area < kLeastInner) return Measured::none(msg::kWallTooLow);
    measured.insert(measured.end(), inner.begin(), inner.end());
    double cosine = 0;
    Vec3 centre = Vec3::Zero();
    for (const std::uint32_t i : inner) {
        const Facet& facet = surfaces.facets[i];
        cosine += facet.area / area * facet.normal.dot(preparation.axis);
        centre += facet.area / area * facet.centre;
    }
    const double angle = std::asin(std::clamp(cosine, -1.0, 1.0)) / kDegree;
    return Measured::at(surfaces.isCrown ? angle : 0 - angle, centre);
}

Measured sumOf(const CutSurfaces& surfaces, const Measured& a, const Measured& b) {
    if (!surfaces.isCrown) return Measured::none(msg::kNoCrownPreparation);
    if (!a.value) return a;
    if (!b.value) return b;
    return Measured::of(*a.value + *b.value);
}

}  // namespace

CavityForm cavityForm(const Preparation& preparation, const CutSurfaces& surfaces) {
    CavityForm form;
    measureFloor(preparation, surfaces, form);
    const double steepness = surfaces.isCrown ? kAxialCosine : kWallCosine;
    CutPatch walls = patchBetween(surfaces, preparation.axis, -steepness, steepness);
    if (surfaces.isCrown) walls = axialPart(preparation, surfaces, walls);
    const DentalDirections to(preparation.axis, preparation.mesialX);
    const std::array<Vec3, 4> sides = {to.buccal, -to.buccal, to.mesial, -to.mesial};
    CutPatch inner;  // of all walls
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const bool exists = i < 2 ? to.hasBuccal : to.hasMesial;
        if (surfaces.facets.empty()) {
            form.wallAngle[i] = Measured::none(msg::kNothingCut);
        } else if (!exists) {
            form.wallAngle[i] = Measured::none(msg::kNoSuchWall);
        } else {
            form.wallAngle[i] = wallAngle(preparation, surfaces, walls, sides[i], inner);
        }
    }
    form.tocMesiodistal = sumOf(surfaces, form.wallAngle[2], form.wallAngle[3]);
    form.tocBuccolingual = sumOf(surfaces, form.wallAngle[0], form.wallAngle[1]);
    form.toc = convergence(preparation, surfaces, walls, inner);
    return form;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/random_cutting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/pose.h"
#include "instruments/bur_shape.h"
#include "support/mesh_checks.h"
#include "tooth/file/debris.h"

namespace tactooth::test {
namespace {

constexpr double kStep = 0.1;      // mm for each carve: 10 mm/s for ten milliseconds
constexpr double kPlunge = 0.5;    // mm for each carve of the long paths through the tooth
constexpr double kThickest = 0.1;  // mm, of a thin wall

std::shared_ptr<const LayeredTooth> toothOf(TriangleMesh outer) {
    return std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(std::move(outer))));
}

/// The rotation that brings the shaft to `axis`.
Quat shaftAlong(const Vec3& axis) { return shortestRotation(Vec3::UnitZ(), axis); }

}  // namespace

RandomCutting::RandomCutting(TriangleMesh outer, double voxel, const std::vector<std::string>& burs, unsigned seed)
    : volume_(toothOf(std::move(outer)), voxel), surface_(volume_), random_(seed) {
    const TriangleMesh& mesh = volume_.tooth()->outer()->mesh();
    box_ = boundingBox(mesh);
    whole_ = volumeOf(mesh);
    for (const std::string& number : burs)
        burs_.push_back(*RevolutionEnvelope::make(makeBur(*findBur(number)).surface));
}

Vec3 RandomCutting::direction() {
    Vec3 vector;
    do {
        vector = Vec3(unit(), unit(), unit());
    } while (vector.norm() < 0.1 || vector.norm() > 1);
    return vector.normalized();
}

Vec3 RandomCutting::placeInside() {
    return box_.center() + 0.45 * Vec3(unit(), unit(), unit()).cwiseProduct(box_.sizes());
}

void RandomCutting::move(const RevolutionEnvelope& bur, const Pose& from, const Pose& to, double longestStep) {
    const double length = (to.position - from.position).norm() + from.rotation.angularDistance(to.rotation);
    const int steps = std::max(1, static_cast<int>(std::ceil(length / longestStep)));
    const auto at = [&](int i) {
        const double t = static_cast<double>(i) / steps;
        return Pose{Vec3(from.position + t * (to.position - from.position)), from.rotation.slerp(t, to.rotation)};
    };
    for (int i = 0; i < steps; ++i) {
        const CarveResult result = volume_.carve(bur, at(i), at(i + 1));
        surface_.update(volume_, result.changed);
        removed_ += total(result.removed);
        if (check_) check_();
    }
}

std::size_t RandomCutting::removeDetached() {
    const DetachedPieces detached = volume_.removeDetached();
    surface_.update(volume_, detached.carve.changed);
    const CarveResult debris =
        volume_.removeDebris(nodesBesideDebris(*surface_.snapshot(), volume_.bricks(), volume_.lattice()));
    surface_.update(volume_, debris.changed);
    removed_ += total(detached.carve.removed) + total(debris.removed);
    return detached.volumes.size();
}

void RandomCutting::stroke() {
    const RevolutionEnvelope& bur = burs_[random_() % burs_.size()];
    switch (random_() % 8) {
        case 0:
            return through(bur);
        case 1:
            return thinWall(bur);
        case 2:
            return detachedBit(bur);
        case 3:
            return alongNodes(bur);
        default:
            return anywhere(bur);
    }
}

/// Begins and ends anywhere, leans and rotates.
void RandomCutting::anywhere(const RevolutionEnvelope& bur) {
    const Pose from{placeInside(), shaftAlong(direction())};
    const Pose to{from.position + direction(), from.rotation.slerp(0.2, shaftAlong(direction()))};
    move(bur, from, to, kStep);
}

/// With the tip first through the tooth and out on the other side.
void RandomCutting::through(const RevolutionEnvelope& bur) {
    const Vec3 axis = direction();
    const Vec3 place = placeInside();
    const double reach = 0.6 * box_.diagonal().norm();
    move(bur, {place + reach * axis, shaftAlong(axis)}, {place - 0.3 * reach * axis, shaftAlong(axis)}, kPlunge);
}

/// Two slots side by side. The wall between them is thinner than a voxel, or does not exist.
void RandomCutting::thinWall(const RevolutionEnvelope& bur) {
    const Quat shaft = shaftAlong(direction());
    const Vec3 along = shaft * Vec3::UnitX();
    const Vec3 place = placeInside();
    const double between = 2 * bur.maxRadius() + kThickest * (0.5 + 0.6 * unit());
    const Vec3 across = shaft * Vec3::UnitY() * between;
    const Vec3 skew = 0.02 * direction();
    move(bur, {place, shaft}, {place + along, shaft}, kStep);
    move(bur, {place + across, shaft}, {place + across + along + skew, shaft}, kStep);
}

/// Once around a cone with the tip at its apex. The piece inside is detached if the bur reaches out of the tooth.
void RandomCutting::detachedBit(const RevolutionEnvelope& bur) {
    const Quat frame = shaftAlong(direction());
    const Vec3 tip = placeInside();
    const double lean = 0.5 + 0.2 * unit();
    constexpr int kSides = 24;
    const auto at = [&](int i) {
        const double turn = 2 * std::numbers::pi * i / kSides;
        const Vec3 axis =
            frame * Vec3(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
        return Pose{tip, shaftAlong(axis)};
    };
    for (int i = 0; i < kSides; ++i) move(bur, at(i), at(i + 1), kStep);
}

/// Along an axis of the lattice, with the tip on a plane of nodes and one side of the bur on another.
void RandomCutting::alongNodes(const RevolutionEnvelope& bur) {
    const int axis = static_cast<int>(random_() % 3);
    const double sign = random_() % 2 == 0 ? 1 : -1;
    const Lattice& lattice = volume_.lattice();
    Vec3 tip = placeInside();
    for (int i = 0; i < 3; ++i) {
        const double spacing = lattice.spacing();
        const double origin = lattice.node(0, 0, 0)[i];
        tip[i] = origin + spacing * std::round((tip[i] - origin) / spacing);
    }
    tip[(axis + 1) % 3] += bur.maxRadius() + kDefaultClearance * lattice.spacing();
    Vec3 end = tip;
    end[(axis + 2) % 3] += 40 * lattice.spacing();
    const Quat shaft = shaftAlong(sign * Vec3::Unit(axis));
    move(bur, {tip, shaft}, {end, shaft}, kStep);
}

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/pair_list.h"

#include <algorithm>
#include <cmath>

// Pair list with a skin: L. Verlet, "Computer Experiments on Classical Fluids", Phys. Rev. 159, 1967. Differs from the
// paper: a pair carries a separating direction with its gap, so a move along the surface, or away from it, does not
// use the gap up.

namespace tactooth {
namespace {

constexpr std::size_t kMaxPairs = 1 << 15;    // a bur that fills its own slot in a 25 um mesh lists some 20,000
constexpr std::size_t kPlentyOfPairs = 3072;  // a longer list costs more to walk than listing twice
constexpr double kLeastReach = 0.002;         // of the tool's radius: 20 um for a bur of 20 mm with its shank
constexpr double kGreatestReach = 1.0;        // of the tool's radius
constexpr double kRounding = 1e-6;            // of a length computed in single precision by a few operations

}  // namespace

PairList::PairList(const ToolShape& tool)
    : found_(kMaxPairs),
      order_(kMaxPairs),
      certificates_(kMaxPairs / 8),
      reachCap_(kGreatestReach * tool.radius()),
      centre_(tool.centre()),
      radius_(tool.radius()) {}

double PairList::leastReach() const { return kLeastReach * radius_; }

void PairList::make(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth, double wantedReach) {
    const double least = leastReach();
    const double greatest = kGreatestReach * radius_;
    const std::span<NearPair> plenty = std::span(found_).first(kPlentyOfPairs);
    reach_ = std::clamp(wantedReach, least, std::max(least, reachCap_));
    reachCap_ = std::min(2 * reachCap_, greatest);
    NearPairsFound found;
    while (true) {
        const bool shortest = reach_ <= least;
        found = findNearPairs(surface, tool, toolInTooth, reach_, shortest ? std::span(found_) : plenty);
        if (found.complete || shortest) break;
        reachCap_ = reach_ = std::max(least, reach_ / 2);
    }
    if (4 * found.count > kPlentyOfPairs) reachCap_ = std::min(reachCap_, reach_);  // the next list may be as dense
    at_ = toolInTooth;
    rotation_ = at_.rotation.toRotationMatrix();
    sortByDistance(tool, found.count);
    if (!found.complete) reach_ = 0;
    made_ = true;
}

void PairList::sortByDistance(const ToolShape& tool, std::size_t count) {
    count_ = count;
    bucketStart_.fill(0);
    const auto scale = static_cast<float>(kBuckets / reach_);
    const auto bucketOf = [scale](const NearPair& pair) {
        return std::min(kBuckets - 1, static_cast<int>(pair.distanceAtLeast * scale));
    };
    for (std::size_t i = 0; i < count; ++i) ++bucketStart_[bucketOf(found_[i]) + 1];
    for (int i = 0; i < kBuckets; ++i) bucketStart_[i + 1] += bucketStart_[i];
    std::array<std::uint32_t, kBuckets + 1> next = bucketStart_;
    for (std::size_t i = 0; i < count; ++i) {
        const NearPair& pair = found_[i];
        const std::uint32_t place = next[bucketOf(pair)]++;
        order_[place] = static_cast<std::uint32_t>(i);
        const ToolShape::Ball& ball = tool.ball(pair.tool);
        Certificates& eight = certificates_[place / 8];
        const std::uint32_t lane = place % 8;
        for (int axis = 0; axis < 3; ++axis) {
            eight.normal[axis][lane] = pair.normal[axis];
            eight.centre[axis][lane] = ball.centre[axis];
        }
        eight.gap[lane] = pair.distanceAtLeast;
        eight.radius[lane] = ball.radius;
    }
}

double PairList::travelTo(const Quat& rotation, const Vec3& position) const {
    const Vec3 centre = rotation * centre_ + position;
    return (centre - at_ * centre_).norm() + 2 * sineOfHalfAngle(rotation, at_.rotation) * radius_;
}

Excursion::Way PairList::wayTo(const Pose& pose, double spare) const {
    const Mat3 turn = rotation_.transpose() * pose.rotation.toRotationMatrix() - Mat3::Identity();
    const Vec3 shift = rotation_.transpose() * (pose.position - at_.position);
    const double perLength = 2 * sineOfHalfAngle(pose.rotation, at_.rotation);
    const double reach = centre_.norm() + radius_;
    const double rounding = kRounding * (reach_ + shift.norm() + perLength * reach);
    return {turn.cast<float>(), shift.cast<float>(), static_cast<float>(perLength * (1 + kRounding)),
            static_cast<float>(spare + rounding)};
}

Excursion PairList::excursion(const Pose& start, const Pose& end, double margin) const {
    return {wayTo(start, 0), wayTo(end, margin),
            std::max(travelTo(start.rotation, start.position), travelTo(end.rotation, end.position)) + margin};
}

std::size_t PairList::withinReachOf(const Excursion& excursion) const {
    const double bucket = std::floor(excursion.greatest * kBuckets / reach_ * (1 + kRounding)) + 1;
    return bucket >= kBuckets ? count_ : bucketStart_[static_cast<int>(bucket)];
}

/// One bit for each of eight certificates that leaves what it must with the tool moved by `way`.
std::uint32_t PairList::holds(std::size_t first, const Excursion::Way& way) const {
    const Certificates& eight = certificates_[first / 8];
    const Vec3x8 n = Vec3x8::load(eight.normal);
    const auto column = [&](int i) { return Vec3x8::all(way.turn(0, i), way.turn(1, i), way.turn(2, i)); };
    const Vec3x8 turned = {dot(n, column(0)), dot(n, column(1)), dot(n, column(2))};
    const Float8 moved = dot(n, Vec3x8::all(way.shift.x(), way.shift.y(), way.shift.z()));
    const Float8 left = Float8::load(eight.gap) + moved + dot(turned, Vec3x8::load(eight.centre));
    return lessEqual(Float8::load(eight.radius) * Float8::all(way.perLength) + Float8::all(way.spare), left);
}

std::uint32_t PairList::inDoubt(std::size_t first, const Excursion& excursion) const {
    const std::size_t rest = count_ - first;
    return ~(holds(first, excursion.start) & holds(first, excursion.end)) & (rest >= 8 ? 0xFFU : (1U << rest) - 1U);
}

Vec3 PairList::direction(std::size_t i) const {
    const auto& n = certificates_[i / 8].normal;
    return rotation_ * Vec3(n[0][i % 8], n[1][i % 8], n[2][i % 8]);
}

void PairList::certify(std::size_t i, const Triangle3& tool, const Vec3& normal, double offset) {
    const Vec3 inTool = rotation_.transpose() * normal;
    Certificates& eight = certificates_[i / 8];
    for (int axis = 0; axis < 3; ++axis) eight.normal[axis][i % 8] = static_cast<float>(inTool[axis]);
    eight.gap[i % 8] = static_cast<float>(lowestAlong(tool, inTool) + normal.dot(at_.position) - offset);
}

}  // namespace tactooth

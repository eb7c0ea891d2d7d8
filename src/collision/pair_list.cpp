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
constexpr double kLeastReach = 0.004;         // of the tool's radius: 12 um for a 6 mm bur
constexpr double kGreatestReach = 1.0;        // of the tool's radius
constexpr double kRounding = 1e-6;            // of a length computed in single precision by a few operations

}  // namespace

PairList::PairList(const ToolShape& tool)
    : found_(kMaxPairs),
      order_(kMaxPairs),
      normal_{std::vector<float>(kMaxPairs), std::vector<float>(kMaxPairs), std::vector<float>(kMaxPairs)},
      gap_(kMaxPairs),
      reachCap_(kGreatestReach * tool.radius()),
      centre_(tool.centre()),
      radius_(tool.radius()) {}

void PairList::make(const Surface& surface, const ToolShape& tool, const Pose& toolInTooth, double wantedReach) {
    const double least = kLeastReach * radius_;
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
    sortByDistance(found.count);
    if (!found.complete) reach_ = 0;
    made_ = true;
}

void PairList::sortByDistance(std::size_t count) {
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
        for (int axis = 0; axis < 3; ++axis) normal_[axis][place] = pair.normal[axis];
        gap_[place] = pair.distanceAtLeast;
    }
}

double PairList::travelTo(const Quat& rotation, const Vec3& position) const {
    const Vec3 centre = rotation * centre_ + position;
    return (centre - at_ * centre_).norm() + 2 * sineOfHalfAngle(rotation, at_.rotation) * radius_;
}

Excursion PairList::excursion(const Pose& start, const Pose& end, double margin) const {
    const Vec3 atStart = rotation_.transpose() * (start * centre_ - at_ * centre_);
    const Vec3 atEnd = rotation_.transpose() * (end * centre_ - at_ * centre_);
    const double turnAtStart = 2 * sineOfHalfAngle(start.rotation, at_.rotation) * radius_;
    const double turnAtEnd = 2 * sineOfHalfAngle(end.rotation, at_.rotation) * radius_;
    const double greatest = std::max(atStart.norm() + turnAtStart, atEnd.norm() + turnAtEnd) + margin;
    const double rounding = kRounding * (reach_ + greatest);
    return {atStart.cast<float>(), atEnd.cast<float>(), static_cast<float>(turnAtStart + rounding),
            static_cast<float>(turnAtEnd + margin + rounding), greatest};
}

std::size_t PairList::withinReachOf(const Excursion& excursion) const {
    const double bucket = std::floor(excursion.greatest * kBuckets / reach_ * (1 + kRounding)) + 1;
    return bucket >= kBuckets ? count_ : bucketStart_[static_cast<int>(bucket)];
}

std::uint32_t PairList::inDoubt(std::size_t first, const Excursion& excursion) const {
    const Vec3x8 normal = {Float8::load(&normal_[0][first]), Float8::load(&normal_[1][first]),
                           Float8::load(&normal_[2][first])};
    const Float8 gap = Float8::load(&gap_[first]);
    const Vec3x8 start = Vec3x8::all(excursion.start.x(), excursion.start.y(), excursion.start.z());
    const Vec3x8 end = Vec3x8::all(excursion.end.x(), excursion.end.y(), excursion.end.z());
    const std::uint32_t holds = lessEqual(Float8::all(excursion.atStart), gap + dot(normal, start)) &
                                lessEqual(Float8::all(excursion.atEnd), gap + dot(normal, end));
    const std::size_t rest = count_ - first;
    return ~holds & (rest >= 8 ? 0xFFU : (1U << rest) - 1U);
}

Vec3 PairList::direction(std::size_t i) const { return rotation_ * Vec3(normal_[0][i], normal_[1][i], normal_[2][i]); }

void PairList::certify(std::size_t i, const Triangle3& tool, const Vec3& normal, double offset) {
    const Vec3 inTool = rotation_.transpose() * normal;
    for (int axis = 0; axis < 3; ++axis) normal_[axis][i] = static_cast<float>(inTool[axis]);
    gap_[i] = static_cast<float>(lowestAlong(tool, inTool) + normal.dot(at_.position) - offset);
}

}  // namespace tactooth

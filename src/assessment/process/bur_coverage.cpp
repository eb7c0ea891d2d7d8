// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/bur_coverage.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <ranges>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"
#include "session/simulation/session_voxel.h"

namespace tactooth {
namespace {

constexpr double kRings = 0.3, kHeadPart = 4;  // mm
constexpr int kAround = 8;
constexpr double kStep = 0.05;       // s between two poses that are looked at
constexpr double kMostPoses = 6000;  // of a long session
constexpr double kLeastSpeed = 100;  // rpm: a slower bur stands

/// A pose of the drilling bur.
struct DrillingPose {
    Pose inTooth;
    const std::vector<Vec3>* head;
};

/// The poses of the drilling bur at equal intervals.
class DrillingPoses {
public:
    DrillingPoses(const SessionTrack& track, const Pose& sessionInTooth) {
        const double step = std::max(kStep, track.seconds() / kMostPoses);
        double next = 0;
        std::uint64_t moment = 0;
        track.forEachTick(0, track.ticks(), [&](const TrackTick& tick) {
            ++moment;
            if (tick.time < next) return;
            next = step * (std::floor(tick.time / step) + 1);
            if (!tick.placed || tick.contacts == 0 || tick.speedRpm <= kLeastSpeed) return;
            const auto& turn = tick.rotation;
            const Pose pose{Vec3(tick.position[0], tick.position[1], tick.position[2]),
                            Quat(turn[3], turn[0], turn[1], turn[2])};
            if (const auto* head = headAt(track, moment)) poses_.push_back({sessionInTooth * pose, head});
        });
    }
    [[nodiscard]] const std::vector<DrillingPose>& all() const { return poses_; }

private:
    const std::vector<Vec3>* headAt(const SessionTrack& track, std::uint64_t moment) {
        const std::shared_ptr<const TrackBur> bur = track.burAt(moment);
        if (bur == nullptr) return nullptr;
        if (bur != bur_) heads_.push_back(headPlaces(bur->begin.instrument.cutting.envelope));
        bur_ = bur;
        return &heads_.back();
    }

    std::vector<DrillingPose> poses_;
    std::deque<std::vector<Vec3>> heads_;  // they stay where they are
    std::shared_ptr<const TrackBur> bur_;
};

BurCoverage noCoverage(const MessageText& reason) {
    return {Measured::none(reason), Measured::none(reason), Measured::none(reason)};
}

}  // namespace

std::vector<Vec3> headPlaces(const RevolutionEnvelope& head) {
    std::vector<Vec3> places;
    const auto addRing = [&](const Vec2& ring) {  // radius, z
        const int count = ring.x() > 0 ? kAround : 1;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            places.emplace_back(ring.x() * std::cos(angle), ring.x() * std::sin(angle), ring.y());
        }
    };
    Vec2 last(head.profile().front().radius, head.bottom());
    addRing(last);
    for (const RevolutionEnvelope::ProfilePoint& corner : head.profile()) {
        const Vec2 next(corner.radius, corner.z);
        const double length = (next - last).norm();
        if (length < kRings / 2) continue;
        const Vec2 start = last;
        const int steps = static_cast<int>(std::ceil(length / kRings));
        for (int i = 1; i <= steps; ++i) {
            last = start + static_cast<double>(i) / steps * (next - start);
            if (last.y() > head.bottom() + kHeadPart) return places;
            addRing(last);
        }
    }
    return places;
}

bool TargetRegion::isInTarget(const Vec3& place) const {
    return contains(*original_, place) && !closestPoint(*original_, place, kCavityDepth) &&
           !closestPoint(*ideal_, place, kCavityDepth);
}

/// To its walls, or to the uncut surface above it.
double TargetRegion::toTarget(const Vec3& place) const {
    const double toWalls = closestPoint(walls_, place)->distance;
    const auto onSurface = closestPoint(*original_, place, toWalls);
    if (!onSurface || signedDistance(*ideal_, onSurface->point) <= kCavityDepth) return toWalls;
    return onSurface->distance;
}

double TargetRegion::beyond(std::span<const Vec3> places) const {
    double deepest = 0;
    bool isIn = false;
    for (const Vec3& place : places) {
        if (contains(*ideal_, place)) {
            deepest = std::max(deepest, closestPoint(*ideal_, place)->distance);
        } else {
            isIn = isIn || isInTarget(place);
        }
    }
    if (isIn || places.empty()) return deepest;
    const auto distances = places | std::views::transform([this](const Vec3& place) { return toTarget(place); });
    return std::max(deepest, std::ranges::min(distances));
}

BurCoverage burCoverage(const Preparation& preparation, const CutSurfaces& surfaces, const SessionTrack* track,
                        const Pose& sessionInTooth) {
    if (track == nullptr) return noCoverage(msg::kNoSession);
    if (surfaces.idealCut.mesh.empty()) return noCoverage(msg::kIdealRemovesNothing);
    const DrillingPoses drilling(*track, sessionInTooth);
    const std::vector<DrillingPose>& poses = drilling.all();
    if (poses.empty()) return noCoverage(msg::kNeverDrilled);
    const TargetRegion target(preparation.original, preparation.ideal, surfaces.idealCut.mesh);
    std::vector<double> beyond(poses.size());
    constexpr std::size_t kGrain = 16;
    parallelFor(
        poses.size(),
        [&](std::size_t i) {
            std::vector<Vec3> places;
            for (const Vec3& each : *poses[i].head) places.push_back(poses[i].inTooth * each);
            beyond[i] = target.beyond(places);
        },
        kGrain);
    const auto share = [&](double most) {
        return static_cast<double>(std::ranges::count_if(beyond, [most](double each) { return each <= most; })) /
               static_cast<double>(beyond.size());
    };
    const double inTarget = share(kSessionVoxel), inBand = share(std::max(kSessionVoxel, preparation.tolerance));
    return {Measured::of(inTarget), Measured::of(inBand - inTarget), Measured::of(1 - inBand)};
}

}  // namespace tactooth

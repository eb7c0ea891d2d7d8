// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/util/assert.h"
#include "tooth/volume/bur_feed.h"

// Verlet lists (L. Verlet, "Computer 'Experiments' on Classical Fluids", Physical Review 159, 1967): a list of all
// pairs within a margin stays complete until something has moved by that margin. Ours differs in two points: the margin
// follows the measured motion of the tool, and another thread builds the list before it is needed.

namespace tactooth {
namespace {

// Distance beyond the expected path that a list covers at least: how far a bur of 10 mm/s strays in five ticks, mm ...
constexpr double kMinAround = 0.05;
// ... and the rotation of a hand of 50 degrees/s in 10 ms: a chord, as in ContactMargin.
constexpr double kMinTurn = 0.008;

constexpr double kMemory = 0.005;      // s, low-pass of the motion: a cutting bur does not move steadily
constexpr double kMinPause = 0.001;    // s: one call each tick
constexpr double kMaxPause = 0.05;     // s: after a longer pause the tool may be anywhere
constexpr double kLifetime = 1.5;      // pauses: a list lasts until the next one comes, and a little longer
constexpr double kDriftMargin = 0.25;  // share of the expected path by which the tool may leave it
constexpr double kMaxDrift = 0.2;      // mm: building a longer list takes longer than the list lasts
constexpr double kCutAhead = 0.05;     // mm: how far a bur moves until the next list, where a cut lets it
constexpr double kSeparation = 1e-6;   // mm: more than the margin of a tool, see ProxySolver::margin
// Share of the margin: a list is renewed while the servo thread can still wait for the new one.
constexpr double kReuseFraction = 0.8;

// While a long list is built, the tool moves on, so that the next list has to reach even farther. So the size of a list
// is bounded to what takes three milliseconds, and each list starts with the final length of the last one.
constexpr std::size_t kCapacity = 1 << 14;                // clusters, 5 MB
constexpr std::size_t kUsualClusters = kCapacity / 2;     // a larger list is followed by a shorter one,
constexpr double kShrinkage = 0.7;                        // of this share of its length;
constexpr std::size_t kFewClusters = kUsualClusters / 2;  // a list with fewer clusters by a longer one, if needed,
constexpr double kGrowth = 2;                             // of this many times its length

}  // namespace

HapticSurfaceBuilder::HapticSurfaceBuilder(std::shared_ptr<const ToolShape> tool,
                                           std::shared_ptr<const Surface> surface)
    : tool_(std::move(tool)), surface_(std::move(surface)) {
    TACTOOTH_ASSERT(tool_ != nullptr);
    TACTOOTH_ASSERT(surface_ != nullptr);
}

void HapticSurfaceBuilder::watch(double time, const Pose& toolInTooth, std::uint32_t ownListRebuilds) {
    TACTOOTH_ASSERT(std::isfinite(time));
    TACTOOTH_ASSERT(isRigid(toolInTooth));
    isListStale_ |= ownListRebuilds != std::exchange(ownListRebuilds_, ownListRebuilds);
    const double pause = time - time_;
    if (time_ >= 0 && pause > 0 && pause <= kMaxPause) {
        const double share = pause_ > 0 ? 1 - std::exp(-pause / kMemory) : 1;
        pause_ += share * (pause - pause_);
        velocity_ += share * ((toolInTooth.position - pose_.position) / pause - velocity_);
        spin_ += share * (chordBetween(toolInTooth.rotation, pose_.rotation) / pause - spin_);
    } else if (time_ < 0 || pause != 0) {
        velocity_.setZero();
        pause_ = spin_ = 0;
    }
    TACTOOTH_ASSERT(pause_ >= 0 && pause_ <= kMaxPause);
    TACTOOTH_ASSERT(spin_ >= 0 && velocity_.allFinite());
    time_ = time;
    pose_ = toolInTooth;
}

/// How long a list must last, s.
double HapticSurfaceBuilder::ahead() const { return kLifetime * std::max(pause_, kMinPause); }

/// Expected displacement of the tool during that time, at most kMaxDrift, mm.
Vec3 HapticSurfaceBuilder::drift() const {
    const Vec3 displacement = ahead() * velocity_;
    const double length = displacement.norm();
    return length > kMaxDrift ? Vec3(kMaxDrift / length * displacement) : displacement;
}

HapticSurface* HapticSurfaceBuilder::list(const Pose& at, const ContactMargin& contactMargin) {
    TACTOOTH_ASSERT(surface_ != nullptr);
    TACTOOTH_ASSERT(longest_ > 0);
    TACTOOTH_ASSERT(contactMargin.around >= 0 && contactMargin.turn >= 0);
    TACTOOTH_ASSERT(free_.size() <= all_.size());
    if (free_.empty()) {
        all_.push_back(std::make_unique<HapticSurface>(HapticSurface{nullptr, NeighbourList(*tool_, kCapacity)}));
        free_.push_back(all_.back().get());
    }
    HapticSurface* hapticSurface = free_.back();
    free_.pop_back();
    hapticSurface->surface = surface_;
    hapticSurface->place.reset();
    hapticSurface->near.buildWithinCapacity(*surface_, at, contactMargin, kMinAround, longest_);
    listedAt_ = at;
    listed_ = hapticSurface->near.contactMargin();
    const std::size_t clusters = hapticSurface->near.clusters();
    const double growth = clusters > kUsualClusters ? kShrinkage : clusters < kFewClusters ? kGrowth : 1;
    longest_ = growth * listed_.length();
    isListStale_ = false;
    return hapticSurface;
}

HapticSurface* HapticSurfaceBuilder::make(std::shared_ptr<const Surface> surface, const Pose& from, const Pose& to) {
    TACTOOTH_ASSERT(surface != nullptr);
    TACTOOTH_ASSERT(isRigid(from));
    TACTOOTH_ASSERT(isRigid(to));
    surface_ = std::move(surface);
    const double length = (to.position - from.position).norm();
    const Pose next = between(from, to, length > kCutAhead ? kCutAhead / length : 1);
    const ContactMargin displacement{next.position - from.position, 0, 0};
    HapticSurface* hapticSurface =
        list(from, {displacement.along, kMinAround + displacement.deviation(drift()), kMinTurn + spin_ * ahead()});
    hapticSurface->near.separateAhead(*surface_, from, next, kSeparation);
    hapticSurface->reach = to.position;
    return hapticSurface;
}

HapticSurface* HapticSurfaceBuilder::rebuild() {
    if (time_ < 0) return nullptr;
    const Vec3 displacement = drift();
    const double turn = spin_ * ahead();
    const double deviation = std::max(listed_.deviation(pose_.position - listedAt_.position),
                                      listed_.deviation(pose_.position + displacement - listedAt_.position));
    const double turned = chordBetween(pose_.rotation, listedAt_.rotation);
    if (!isListStale_ && deviation < kReuseFraction * listed_.around && turned + turn < kReuseFraction * listed_.turn)
        return nullptr;
    HapticSurface* hapticSurface =
        list(pose_, {2 * displacement, kMinAround + kDriftMargin * displacement.norm(), kMinTurn + 2 * turn});
    hapticSurface->near.separateAhead(*surface_, pose_, {pose_.position + displacement, pose_.rotation}, kSeparation);
    hapticSurface->reach = pose_.position;
    return hapticSurface;
}

HapticSurface* HapticSurfaceBuilder::place(std::shared_ptr<const Surface> surface, const Pose& deviceInTooth) {
    TACTOOTH_ASSERT(surface != nullptr);
    TACTOOTH_ASSERT(isRigid(deviceInTooth));
    if (!query_) query_.emplace(tool_, surface);
    query_->setSurface(surface);
    if (!(query_->at(deviceInTooth).depth > 0)) return nullptr;
    const Pose free = query_->freePose();
    HapticSurface* hapticSurface = make(std::move(surface), free, free);
    hapticSurface->place = free;
    return hapticSurface;
}

void HapticSurfaceBuilder::recycle(HapticSurface* hapticSurface) {
    TACTOOTH_ASSERT(hapticSurface != nullptr);
    TACTOOTH_ASSERT(std::ranges::find(free_, hapticSurface) == free_.end());
    TACTOOTH_ASSERT(std::ranges::any_of(all_, [&](const auto& owned) { return owned.get() == hapticSurface; }));
    hapticSurface->surface = nullptr;
    free_.push_back(hapticSurface);
}

}  // namespace tactooth

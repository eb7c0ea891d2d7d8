// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tooth/volume/bur_feed.h"

namespace tactooth {
namespace {

// How far beyond the way expected the list reaches at least: what a bur of 10 mm/s strays in five ticks, mm ...
constexpr double kAround = 0.05;
// ... and that a hand turns at 50 degrees/s for 10 ms: a chord, as in Skin.
constexpr double kTurn = 0.008;

constexpr double kMemory = 0.005;       // s: a bur that cuts goes by fits and starts
constexpr double kShortest = 0.001;     // s: a look at each tick
constexpr double kLongest = 0.05;       // s: after a longer pause the tool may be anywhere
constexpr double kUntilNext = 1.5;      // pauses: a list lasts until the next one comes, and some more
constexpr double kDriftMargin = 0.25;   // of the way expected: how far the tool may leave it
constexpr double kMaxDrift = 0.2;       // mm: a longer list takes longer to make than it lasts
constexpr double kCutAhead = 0.05;      // mm: what the bur gains until the next list, where a cut lets it
constexpr double kApart = 1e-6;         // mm: what a tool keeps from the tooth is less, see ProxySolver::margin
constexpr double kReuseFraction = 0.8;  // of the skin: a list is renewed while the tick can still wait for the new one

// While a long list is made the tool goes on, so that the next one has to reach farther still. So a list is no longer
// than takes three milliseconds, and begins with the length that the last one ended with.
constexpr std::size_t kRoom = 1 << 14;       // clusters, 5 MB
constexpr std::size_t kUsual = kRoom / 2;    // a list that is longer shall be followed by a shorter one,
constexpr double kShorter = 0.7;             // of its length;
constexpr std::size_t kLittle = kUsual / 2;  // one with less by a longer one, if that is wanted,
constexpr double kLonger = 2;                // times its length

}  // namespace

void HapticSurfaceBuilder::watch(double time, const Pose& toolInTooth, std::uint32_t ownListRebuilds) {
    isListStale_ |= ownListRebuilds != std::exchange(ownListRebuilds_, ownListRebuilds);
    const double pause = time - time_;
    if (time_ >= 0 && pause > 0 && pause <= kLongest) {
        const double share = pause_ > 0 ? 1 - std::exp(-pause / kMemory) : 1;
        pause_ += share * (pause - pause_);
        velocity_ += share * ((toolInTooth.position - pose_.position) / pause - velocity_);
        spin_ += share * (chordBetween(toolInTooth.rotation, pose_.rotation) / pause - spin_);
    } else if (time_ < 0 || pause != 0) {
        velocity_.setZero();
        pause_ = spin_ = 0;
    }
    time_ = time;
    pose_ = toolInTooth;
}

/// How long a list has to last, s.
double HapticSurfaceBuilder::ahead() const { return kUntilNext * std::max(pause_, kShortest); }

/// Where the tool goes meanwhile, as far as a list is worth it, mm.
Vec3 HapticSurfaceBuilder::drift() const {
    const Vec3 displacement = ahead() * velocity_;
    const double length = displacement.norm();
    return length > kMaxDrift ? Vec3(kMaxDrift / length * displacement) : displacement;
}

HapticSurface* HapticSurfaceBuilder::list(const Pose& at, const ContactMargin& contactMargin) {
    if (free_.empty()) {
        all_.push_back(std::make_unique<HapticSurface>(HapticSurface{nullptr, NeighbourList(*tool_, kRoom)}));
        free_.push_back(all_.back().get());
    }
    HapticSurface* hapticSurface = free_.back();
    free_.pop_back();
    hapticSurface->surface = surface_;
    hapticSurface->place.reset();
    hapticSurface->near.buildWithinCapacity(*surface_, at, contactMargin, kAround, longest_);
    listedAt_ = at;
    listed_ = hapticSurface->near.contactMargin();
    const std::size_t clusters = hapticSurface->near.clusters();
    const double growth = clusters > kUsual ? kShorter : clusters < kLittle ? kLonger : 1;
    longest_ = growth * listed_.length();
    isListStale_ = false;
    return hapticSurface;
}

HapticSurface* HapticSurfaceBuilder::make(std::shared_ptr<const Surface> surface, const Pose& from, const Pose& to) {
    surface_ = std::move(surface);
    const double length = (to.position - from.position).norm();
    const Pose next = between(from, to, length > kCutAhead ? kCutAhead / length : 1);
    const ContactMargin displacement{next.position - from.position, 0, 0};
    HapticSurface* hapticSurface =
        list(from, {displacement.along, kAround + displacement.deviation(drift()), kTurn + spin_ * ahead()});
    hapticSurface->near.separateAhead(*surface_, from, next, kApart);
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
        list(pose_, {2 * displacement, kAround + kDriftMargin * displacement.norm(), kTurn + 2 * turn});
    hapticSurface->near.separateAhead(*surface_, pose_, {pose_.position + displacement, pose_.rotation}, kApart);
    hapticSurface->reach = pose_.position;
    return hapticSurface;
}

HapticSurface* HapticSurfaceBuilder::place(std::shared_ptr<const Surface> surface, const Pose& deviceInTooth) {
    if (!query_) query_.emplace(tool_, surface);
    query_->setSurface(surface);
    if (!(query_->at(deviceInTooth).depth > 0)) return nullptr;
    const Pose free = query_->freePose();
    HapticSurface* hapticSurface = make(std::move(surface), free, free);
    hapticSurface->place = free;
    return hapticSurface;
}

void HapticSurfaceBuilder::recycle(HapticSurface* hapticSurface) {
    hapticSurface->surface = nullptr;
    free_.push_back(hapticSurface);
}

}  // namespace tactooth

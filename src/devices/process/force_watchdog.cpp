// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/force_watchdog.h"

#include <algorithm>
#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kRounding = 1 + 1e-6;      // of a force at the limit
constexpr std::uint32_t kMostMissed = 100;  // forces that a late hand process may miss: 20 ms at the highest rate
constexpr int kInsistence = 3;  // forces after a stall that are not zero: the program has not noticed the stall

}  // namespace

bool ForceWatchdog::isZero(const SafeWrench& wrench) { return wrench.force().isZero(0) && wrench.torque().isZero(0); }

double ForceWatchdog::silentFrom() const {
    const bool isWatched = !isCut_ && !isSilent();
    return isWatched ? messageAt_ + kLongestSilence : std::numeric_limits<double>::infinity();
}

HandFault ForceWatchdog::faultOf(const ForceMessage& message, std::uint32_t published) const {
    if (message.sequence != message.endSequence) return HandFault::WrongSequence;
    if (hasSequence_ && !follows(message.sequence, sequence_, kMostMissed)) return HandFault::WrongSequence;
    const bool isAhead = static_cast<std::int32_t>(published - message.answers) < 0;
    if (isAhead) return HandFault::WrongSequence;
    const Wrench wrench = wrenchFrom(message);
    if (!wrench.force.allFinite() || !wrench.torque.allFinite()) return HandFault::NotANumber;
    const ForceLimits& limits = limiter_.limits();
    // Component by component first: the length of a vector near the largest double would overflow.
    const auto isBeyond = [](const Vec3& vector, double limit) {
        return vector.cwiseAbs().maxCoeff() > limit * kRounding || vector.norm() > limit * kRounding;
    };
    return isBeyond(wrench.force, limits.force) || isBeyond(wrench.torque, limits.torque) ? HandFault::BeyondLimits
                                                                                          : HandFault::None;
}

/// `knowable`: when the fault could be known, s.
void ForceWatchdog::cut(HandFault cause, double knowable, double now) {
    TACTOOTH_ASSERT(knowable <= now);
    isCut_ = true;
    cause_ = cause;
    cutWrench_ = held_;
    fadeFrom_ = now;
    zeroSeen_ = false;
    forcesSinceZero_ = 0;
    record_ = {cause, knowable, held_.force().norm(), 0, false};
    isCutOpen_ = cause != HandFault::None;
}

SafeWrench ForceWatchdog::fade(double now) {
    TACTOOTH_ASSERT(isCut_);
    held_ = limiter_.fade(cutWrench_, 1 - (now - fadeFrom_) / kFadeTime);
    limitedAt_ = now;
    if (isCutOpen_ && isSilent()) {
        isCutOpen_ = false;
        record_.toZero = now - record_.at;
        hasRecord_ = true;
    }
    return held_;
}

SafeWrench ForceWatchdog::take(const ForceMessage& message, const HandMoment& moment) {
    const double now = moment.now;
    const HandFault found = faultOf(message, moment.published);
    if (message.sequence == message.endSequence) {  // later forces follow this one, even if it is refused
        hasSequence_ = true;
        sequence_ = message.sequence;
    }
    if (isLate(now)) cut(HandFault::NoForce, silentFrom(), now);
    if (found != HandFault::None) {
        // A fault of the program counts more than its lateness. One that lasts is one cut.
        if (!isCut_ || (cause_ == HandFault::NoForce && !isForGood_)) cut(found, now, now);
        zeroSeen_ = false;
        return fade(now);
    }
    applied_ = message.sequence;
    messageAt_ = now;
    const Wrench wrench = wrenchFrom(message);
    if (isCut_) {
        const bool isNothing = wrench.force.isZero(0) && wrench.torque.isZero(0);
        zeroSeen_ |= isNothing;
        forcesSinceZero_ += zeroSeen_ ? 0 : 1;
        const bool isOver = zeroSeen_ && isSilent() && !isForGood_;
        if (!isOver) return fade(now);
        isCut_ = false;
        cause_ = HandFault::None;
    }
    const double elapsed = std::max(0.0, now - std::exchange(limitedAt_, now));
    held_ = limiter_.limit(wrench, elapsed, moment.isPoseValid, moment.speed);
    return held_;
}

SafeWrench ForceWatchdog::turn(double now) {
    if (isLate(now)) cut(HandFault::NoForce, silentFrom(), now);
    return isCut_ ? fade(now) : held_;
}

SafeWrench ForceWatchdog::stop() {
    held_ = limiter_.limit({}, 0, false, 0);
    cutWrench_ = held_;
    return held_;
}

void ForceWatchdog::end(HandFault cause, double now) {
    isForGood_ = true;
    if (!isCut_) return cut(cause, now, now);
    if (cause == HandFault::None) return;
    if (!isCutOpen_) {  // an earlier fault has been recorded: this is another one
        record_ = {cause, now, held_.force().norm(), 0, true};
        isCutOpen_ = true;
    } else if (cause_ == HandFault::NoForce) {
        record_.cause = cause;
    }
    cause_ = cause;
}

HandFault ForceWatchdog::fault() const {
    if (!isCut_ || (cause_ == HandFault::NoForce && forcesSinceZero_ < kInsistence)) return HandFault::None;
    return cause_;
}

std::optional<ForceCut> ForceWatchdog::fetchCut() {
    if (!std::exchange(hasRecord_, false)) return std::nullopt;
    return record_;
}

}  // namespace tactooth

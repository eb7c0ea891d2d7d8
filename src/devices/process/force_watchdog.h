// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "devices/process/hand_link.h"
#include "haptics/safety_limiter.h"

namespace tactooth {

/// A fault for which the watchdog has cut a force.
struct ForceCut {
    HandFault cause = HandFault::None;
    double at = 0;            ///< s of the monotonic clock: when the fault could be known
    double force = 0;         ///< N at that moment
    double toZero = 0;        ///< s until the force was zero
    bool isAfterCut = false;  ///< the force was zero already, from the cut before
};

/// What the watchdog knows of the device at a tick.
struct HandMoment {
    double now = 0;               ///< s of the monotonic clock
    double speed = 0;             ///< of the hand, mm/s
    bool isPoseValid = true;      ///< false: no force may be rendered
    std::uint32_t published = 0;  ///< PoseMessage::sequence of the newest pose
};

/// The last check of the program's forces, in the hand process, with a second copy of the safety limiter behind it. A
/// force that is late, is no number, is beyond the limits or is out of order fades to zero within 2 ms and stays zero.
/// Forces pass again once the program itself has sent a force of zero, which it does when it starts anew. It reads no
/// clock, and allocates, locks and logs nothing.
class ForceWatchdog {
public:
    static constexpr double kLongestSilence = 0.003;  ///< s: three ticks at 1 kHz, as ForceLimits::tickTimeout
    static constexpr double kFadeTime = 0.002;  ///< s: of the 5 ms, 3 are left for the device's own tick and delays

    explicit ForceWatchdog(const ForceLimits& limits) : limiter_(limits) {}

    /// The wrench for the device, from a new force of the program.
    [[nodiscard]] SafeWrench take(const ForceMessage& message, const HandMoment& moment);
    /// The wrench for the device at a turn without a new force.
    [[nodiscard]] SafeWrench turn(double now);
    /// Zero at once, for a pose that is not valid: the program does the same in its tick.
    [[nodiscard]] SafeWrench stop();
    /// Fades the force out for good. HandFault::None: the program has asked for it.
    void end(HandFault cause, double now);

    /// Whether the last wrench was zero.
    [[nodiscard]] bool isSilent() const { return isZero(held_); }
    /// Whether a force is fading out, so that it needs turns in quick succession.
    [[nodiscard]] bool isFading() const { return isCut_ && !isSilent(); }
    /// The time at which a turn has to find that the force is late, s; infinite while there is no force.
    [[nodiscard]] double silentFrom() const;
    /// The fault for which the program has to start its force anew. A stall of the program alone is none: its own
    /// limiter has started anew, too.
    [[nodiscard]] HandFault fault() const;
    /// The newest cut whose force has become zero, once.
    [[nodiscard]] std::optional<ForceCut> fetchCut();
    /// Sequence of the newest valid force; 0 before the first.
    [[nodiscard]] std::uint32_t applied() const { return applied_; }

private:
    [[nodiscard]] HandFault faultOf(const ForceMessage& message, std::uint32_t published) const;
    [[nodiscard]] static bool isZero(const SafeWrench& wrench);
    void cut(HandFault cause, double knowable, double now);
    [[nodiscard]] bool isLate(double now) const { return now >= silentFrom(); }
    [[nodiscard]] SafeWrench fade(double now);

    SafetyLimiter limiter_;
    SafeWrench held_;  // the last wrench
    bool hasSequence_ = false;
    std::uint32_t sequence_ = 0;  // of the last force, also of a refused one
    std::uint32_t applied_ = 0;
    double messageAt_ = 0;  // s: arrival of the last valid force
    double limitedAt_ = 0;  // s: last use of the limiter

    // While the force is cut.
    bool isCut_ = false;
    bool isForGood_ = false;
    HandFault cause_ = HandFault::None;
    SafeWrench cutWrench_;     // at the moment of the cut
    double fadeFrom_ = 0;      // s
    bool zeroSeen_ = false;    // the program has sent a zero since
    int forcesSinceZero_ = 0;  // forces that were not zero since then, or since the cut
    bool isCutOpen_ = false;   // `record_` waits for the force to be zero
    ForceCut record_;
    bool hasRecord_ = false;
};

}  // namespace tactooth

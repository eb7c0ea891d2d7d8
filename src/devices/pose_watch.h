// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "haptics/hand_jump.h"

namespace tactooth {

/// Says it when a device tells places where no hand can be. The force is cut by the force pipeline on its own account;
/// this is for the person who wonders why.
class PoseWatch {
public:
    /// The servo's, at each tick. `isFresh`: the place is a new reading. `elapsed`: since the last tick, s.
    void see(const Vec3& place, bool isFresh, double elapsed) {
        sinceLast_ += elapsed;
        left_ -= elapsed;
        if (left_ <= 0) trouble_.store(nullptr, std::memory_order_relaxed);
        if (!isFresh) return;
        if (!place.allFinite()) {
            say("The device tells a place that is no number: switch it off and on again if this comes again.");
        } else if (hasLast_ && isHandJump(place - last_, sinceLast_)) {
            say("The device's place has jumped: check its cable, and let it calibrate if this comes again.");
        }
        hasLast_ = place.allFinite();
        last_ = place;
        sinceLast_ = 0;
    }
    void reset() {
        hasLast_ = false;
        trouble_.store(nullptr, std::memory_order_relaxed);
    }
    /// Any thread; nullptr if nothing is wrong. Lives as long as the program.
    [[nodiscard]] const char* trouble() const { return trouble_.load(std::memory_order_relaxed); }

private:
    static constexpr double kShownFor = 3;  // s: long enough to be read
    void say(const char* sentence) {
        left_ = kShownFor;
        trouble_.store(sentence, std::memory_order_relaxed);
    }

    Vec3 last_ = Vec3::Zero();
    bool hasLast_ = false;
    double sinceLast_ = 0;  // s
    double left_ = 0;       // s
    std::atomic<const char*> trouble_{nullptr};
};

}  // namespace tactooth

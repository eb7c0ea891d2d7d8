// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "geometry/util/message.h"
#include "haptics/pose_validator.h"

namespace tactooth {

/// What a fault of a hand means and what to do about it, one sentence; nullptr for none. Lives as long as the program.
[[nodiscard]] const Message* poseFaultMessage(PoseFault fault);

/// Says it when a device tells poses that no hand can have. The force is cut by the force pipeline on its own account;
/// this is for the person who wonders why.
class PoseMonitor {
public:
    /// The servo's, at each tick. `elapsed`: since the last tick, s.
    void update(PoseFault fault, double elapsed) {
        left_ -= elapsed;
        if (fault != PoseFault::None) {
            left_ = kShownFor;
            faultMessage_.store(poseFaultMessage(fault), std::memory_order_relaxed);
        } else if (left_ <= 0) {
            faultMessage_.store(nullptr, std::memory_order_relaxed);
        }
    }
    /// Any thread; nullptr if nothing is wrong. Lives as long as the program.
    [[nodiscard]] const Message* faultMessage() const { return faultMessage_.load(std::memory_order_relaxed); }

private:
    static constexpr double kShownFor = 3;  // s: long enough to be read

    double left_ = 0;  // s
    std::atomic<const Message*> faultMessage_{nullptr};
};

}  // namespace tactooth

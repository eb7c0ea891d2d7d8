// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "geometry/util/message.h"
#include "haptics/pose_validator.h"

namespace tactooth {

/// Explains a pose fault and its remedy in one sentence; nullptr for none. The message lives as long as the program.
[[nodiscard]] const Message* poseFaultMessage(PoseFault fault);

/// Keeps the message about a pose fault for the user. The force pipeline cuts the force independently of this class;
/// the message explains why.
class PoseMonitor {
public:
    /// Servo thread only, at each tick. `elapsed`: s since the last tick.
    void update(PoseFault fault, double elapsed) {
        left_ -= elapsed;
        if (fault != PoseFault::None) {
            left_ = kShownFor;
            faultMessage_.store(poseFaultMessage(fault), std::memory_order_relaxed);
        } else if (left_ <= 0) {
            faultMessage_.store(nullptr, std::memory_order_relaxed);
        }
    }
    /// Any thread; nullptr without a fault. The message lives as long as the program.
    [[nodiscard]] const Message* faultMessage() const { return faultMessage_.load(std::memory_order_relaxed); }

private:
    static constexpr double kShownFor = 3;  // s: long enough to be read

    double left_ = 0;  // s
    std::atomic<const Message*> faultMessage_{nullptr};
};

}  // namespace tactooth

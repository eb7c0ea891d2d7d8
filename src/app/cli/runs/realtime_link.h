// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "devices/process/hand_process_device.h"
#include "devices/simulated/simulated_driver.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// What it costs to hold a device in a process of its own: a simulated driver is answered in this process, and then
/// through tactooth-hand, by a servo that computes nothing.
class LinkTiming {
public:
    /// Takes twice `seconds`. Fails with one sentence if tactooth-hand cannot be started.
    [[nodiscard]] static Expected<std::unique_ptr<LinkTiming>> measure(double seconds, double rateHz);

    /// Time from a sample to the force that answers it, us.
    [[nodiscard]] const LatencyHistogram& inProcess() const { return driver_.responseTime(); }
    [[nodiscard]] const LatencyHistogram& throughHand() const { return hand_.responseTime(); }
    /// What the second process adds to it, us.
    [[nodiscard]] const LatencyHistogram& added() const { return hand_.addedLatency(); }

private:
    explicit LinkTiming(double rateHz);

    SimulatedDriver driver_;
    HandProcessDevice hand_;
};

}  // namespace tactooth

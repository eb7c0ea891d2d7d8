// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/realtime_link.h"

#include <chrono>
#include <string>
#include <thread>

#include "haptics/servo_loop.h"

namespace tactooth {
namespace {

HandRequest simulatedDriver(double rateHz) {
    HandRequest request;
    request.device = std::string(SimulatedDriver::kName);
    request.rateHz = rateHz;
    return request;
}

/// Answers each sample of an open device with a force of zero.
void answer(HapticDevice& device, double seconds, double rateHz) {
    const ServoLoop loop(
        rateHz,
        [&device](double elapsed) {
            (void)device.read(elapsed);
            device.write(SafeWrench());
        },
        [&device](double longest) { device.waitForTick(longest); });
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace

LinkTiming::LinkTiming(double rateHz) : driver_(rateHz), hand_(simulatedDriver(rateHz)) {}

Expected<std::unique_ptr<LinkTiming>> LinkTiming::measure(double seconds, double rateHz) {
    std::unique_ptr<LinkTiming> timing(new LinkTiming(rateHz));
    HapticDevice* const devices[] = {&timing->driver_, &timing->hand_};
    for (HapticDevice* const device : devices) {
        if (const auto opened = device->open(); !opened) return Unexpected{opened.error()};
        answer(*device, seconds, rateHz);
        device->close();
    }
    return timing;
}

}  // namespace tactooth

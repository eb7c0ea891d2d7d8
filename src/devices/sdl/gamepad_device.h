// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "devices/base/haptic_device.h"
#include "devices/base/rate_controller.h"
#include "devices/base/rumble_filter.h"
#include "devices/sdl/joysticks.h"

namespace tactooth {

/// A gamepad that gives rate control of the tool (see padCommand) and renders the force with its two motors. An
/// unplugged gamepad is lost; the device recovers by itself when the same pad, or another that fits the name, is
/// plugged in.
class GamepadDevice final : public HapticDevice {
public:
    /// `name`: a part of the pad's name; empty: the first pad.
    explicit GamepadDevice(std::string name, bool leftHanded = false);
    ~GamepadDevice() override;

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    /// Fails if no such pad is plugged in.
    [[nodiscard]] Expected<void> open() override;
    void close() override;
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;
    void suspendInput(bool suspended) override { inputSuspended_.store(suspended, std::memory_order_relaxed); }
    [[nodiscard]] const Message* faultMessage() const override;

private:
    std::string name_;
    bool leftHanded_;
    DeviceInfo info_;
    std::shared_ptr<SdlJoysticks> joysticks_;  // while open
    PadPort port_;
    RateController hand_;
    RumbleFilter rumbleFilter_;
    double elapsed_ = 0;  // of the last read, s
    std::atomic<bool> lost_{false};
    std::atomic<bool> inputSuspended_{false};
};

}  // namespace tactooth

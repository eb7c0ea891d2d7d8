// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/base/haptic_device.h"
#include "geometry/util/triple_buffer.h"

namespace tactooth {

/// The mouse as a device without force feedback. The window sets a target pose, and the device pose follows it
/// smoothly: a mouse moves in 60 to 125 steps a second, and a damper needs a continuous velocity.
class MouseDevice final : public HapticDevice {
public:
    explicit MouseDevice(const Pose& start);

    /// Sets the target pose, from the window's thread; wait-free.
    void moveTo(const DeviceSample& target) { target_.write(target); }

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;

private:
    DeviceInfo info_;
    TripleBuffer<DeviceSample> target_;
    Pose hand_;
    Vec3 velocity_ = Vec3::Zero();
};

}  // namespace tactooth

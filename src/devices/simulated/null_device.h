// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/base/haptic_device.h"

namespace tactooth {

/// No device: reports a constant pose and renders no force.
class NullDevice final : public HapticDevice {
public:
    explicit NullDevice(const Pose& rest);

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;

private:
    DeviceInfo info_;
    Pose rest_;
};

}  // namespace tactooth

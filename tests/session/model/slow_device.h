// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "devices/base/haptic_device.h"

namespace tactooth::test {

/// A device whose every reading keeps the servo for 0.7 ms.
class SlowDevice final : public HapticDevice {
public:
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double) override {
        const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(700);
        while (std::chrono::steady_clock::now() < end) {
        }
        return {};
    }
    void write(const SafeWrench&) override {}

private:
    DeviceInfo info_;
};

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// A hand and a foot at one moment of a script.
struct DeviceKeyframe {
    double time;  ///< s
    DeviceSample sample;
};

/// A hand that follows a script, whatever force it meets: between two moments pose and pedal go in a straight line,
/// buttons change with the moment reached. After the last moment it rests there.
class ScriptedDevice final : public HapticDevice {
public:
    /// `script` is not empty and its times do not descend.
    /// `isInToothFrame`: its places are the tool's in the tooth's frame.
    explicit ScriptedDevice(std::vector<DeviceKeyframe> script, std::string name = "scripted hand",
                            bool isInToothFrame = false);

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override;
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override { lastForce_ = wrench.force(); }

    [[nodiscard]] bool finished() const { return time_ >= script_.back().time; }
    [[nodiscard]] const Vec3& lastForce() const { return lastForce_; }

private:
    DeviceInfo info_;
    std::vector<DeviceKeyframe> script_;
    std::size_t next_ = 0;  // first moment that is not reached
    double time_ = 0;
    Vec3 lastForce_ = Vec3::Zero();
};

}  // namespace tactooth

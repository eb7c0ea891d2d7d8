// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// Pose, pedal and buttons at one time of a script.
struct DeviceKeyframe {
    double time;  ///< s
    DeviceSample sample;
};

/// Follows a script, whatever force it meets. Pose and pedal are interpolated linearly between two keyframes; buttons
/// change when a keyframe is reached. After the last keyframe the pose stays constant.
class ScriptedDevice final : public HapticDevice {
public:
    /// `script` must not be empty, and its times must not descend. `isInToothFrame`: its poses are those of the tool in
    /// the tooth frame.
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
    std::size_t next_ = 0;  // first keyframe that is not reached yet
    double time_ = 0;
    Vec3 lastForce_ = Vec3::Zero();
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "devices/base/device_presets.h"
#include "devices/simulated/scripted_device.h"

namespace tactooth {

/// A hand on a device, both with their mechanics, that tries to follow a script and is moved by the force. The device's
/// arm has mass, dry friction and damping, and reports its position in encoder steps. The hand is a mass that a spring
/// and a damper pull toward the position of the script. This closes the control loop as a real device does, without
/// hardware. Time advances only with the calls.
class SimulatedDevice final : public HapticDevice {
public:
    struct OperatorBehaviour {
        double tremor = 0;                                             ///< mm, root mean square over all directions
        double releaseTime = std::numeric_limits<double>::infinity();  ///< s: from this time no hand holds the pen
    };

    /// `script` must not be empty, and its times must not descend; the device starts at the first keyframe.
    SimulatedDevice(const DevicePreset& device, const HandImpedance& hand, std::vector<DeviceKeyframe> script,
                    const OperatorBehaviour& habits);
    SimulatedDevice(const DevicePreset& device, const HandImpedance& hand, std::vector<DeviceKeyframe> script)
        : SimulatedDevice(device, hand, std::move(script), OperatorBehaviour{}) {}

    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override;
    void close() override {}
    [[nodiscard]] DeviceSample read(double elapsed) override;
    void write(const SafeWrench& wrench) override;

    /// True position of the pen's tip, mm, and its velocity, mm/s.
    [[nodiscard]] const Vec3& tip() const { return tip_; }
    [[nodiscard]] const Vec3& speed() const { return speed_; }

private:
    static constexpr int kMaxDelay = 4;
    void move(const Vec3& wanted, const Vec3& wantedSpeed, const Vec3& force, double dt);
    [[nodiscard]] Vec3 tremorOffset(double time) const;

    DevicePreset device_;
    HandImpedance hand_;
    OperatorBehaviour behaviour_;
    DeviceInfo info_;
    ScriptedDevice reference_;
    double time_ = 0;
    Vec3 lastCommand_;
    Vec3 tip_;
    Vec3 speed_ = Vec3::Zero();
    std::array<Vec3, kMaxDelay + 1> forces_;  // newest first
};

}  // namespace tactooth

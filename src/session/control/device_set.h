// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "devices/base/haptic_device.h"
#include "haptics/force_pipeline.h"
#include "session/control/button_actions.h"
#include "session/control/depth_stop.h"
#include "session/control/device_mapping.h"
#include "session/control/wall_guide.h"

namespace tactooth {

/// Settings of the user for the devices while the simulation runs.
struct DeviceControls {
    bool clutch = false;       ///< the instruments stay while the devices move freely
    double motionScaling = 1;  ///< mm of the device for each mm of its instrument
    ButtonMap buttons = {};
    const DepthControl* depthStop = nullptr;  ///< the floor at which the turbine is held; null: it is not held
    const WallGuide* guide = nullptr;         ///< that the hand with the turbine feels; null: there is none
};

/// The user's one or two devices, one for each hand, and the two instruments, turbine and mirror. The first device
/// starts with the turbine, a second one with the mirror. A swap exchanges the instruments of two devices; a single
/// device puts down one instrument and picks up the other. A handover does not move the instrument: the new device
/// takes it where it is. While a device is lost or has a pose fault, its instrument stays where the tooth holds it, so
/// that it neither presses nor cuts. Each device has its own force pipeline, so no force passes from one device to
/// another: the force fades out on the one, and the other renders none before the bur has been in free space. Servo
/// thread only; does not allocate or lock.
class DeviceSet {
public:
    /// The devices must be open and outlive this object. `second`: nullptr for a single device. `registration`: for a
    /// device whose frame is unrelated to the tooth; without it the first device's frame is the tooth's.
    DeviceSet(HapticDevice& first, HapticDevice* second, const std::optional<DeviceRegistration>& registration);
    DeviceSet(const DeviceSet&) = delete;
    DeviceSet& operator=(const DeviceSet&) = delete;

    /// Reads the devices and moves the instruments.
    void read(double elapsed, const DeviceControls& controls);

    /// Pose of the turbine in the tooth frame; NaN before the device that holds it has been read.
    [[nodiscard]] const Pose& turbine() const { return instruments_[kTurbine]; }
    /// Motion of the mirror since the start.
    [[nodiscard]] const Pose& mirror() const { return instruments_[kMirror]; }
    /// Whether a button has switched from touch to cut, or back.
    [[nodiscard]] bool cutToggled() const;
    /// 0 .. 1: the larger value of the pedals.
    [[nodiscard]] double pedal() const;
    /// s since the measurement of the device that holds the turbine; 0 if none holds it.
    [[nodiscard]] double age() const;
    /// Maximum stiffness of the device that holds the turbine, N/mm; infinite if none does.
    [[nodiscard]] double maxStiffness() const;

    /// Sends each device its force: the one that holds the turbine gets the force of the tick, the other one zero.
    void write(const Tick& tick, bool enabled, double elapsed);

    /// The force state of the device that holds the turbine (the first device if none does): why its force is on or
    /// off.
    [[nodiscard]] ForceState forceState() const;
    /// Whether a device has reached the limit of its workspace, as far as the limit is known. The clutch extends the
    /// reach.
    [[nodiscard]] bool isAtWorkspaceLimit() const;
    /// Whether no device renders a force.
    [[nodiscard]] bool isSilent() const { return silent_; }

private:
    static constexpr std::size_t kTurbine = 0;
    static constexpr std::size_t kMirror = 1;
    static constexpr int kNoHolder = -1;

    struct HeldDevice {
        HeldDevice(HapticDevice& held, const std::optional<DeviceRegistration>& turbineRegistration,
                   const DeviceRegistration& mirrorRegistration);
        HapticDevice* device;
        ForcePipeline pipeline;
        std::array<DeviceMapping, 2> frames;  // mappings for turbine and mirror
        ButtonActions buttons;
        DeviceSample sample;
        bool poseValid = false;         // the device is connected and has no pose fault
        bool atWorkspaceLimit = false;  // at the limit of the device's workspace, while the clutch is not held
    };
    [[nodiscard]] int holderOf(std::size_t instrument) const;
    [[nodiscard]] bool swapped() const;
    void move(std::size_t instrument, const DeviceControls& controls, double elapsed);
    void rest(std::size_t instrument);
    [[nodiscard]] ForceCommand wantedFor(const HeldDevice& hand, const Tick& tick, bool enabled) const;

    std::optional<HeldDevice> first_;
    std::optional<HeldDevice> second_;
    std::array<HeldDevice*, 2> devices_;  // nullptr, or pointers to the two above
    std::array<int, 2> holders_ = {0, kNoHolder};
    /// The turbine has no pose until its device was read; the mirror starts where it was parked.
    std::array<Pose, 2> instruments_{Pose{Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), Quat::Identity()},
                                     Pose{}};
    std::optional<Pose> proxy_;  // of the turbine at the last tick
    DepthStop depthStop_;        // of the turbine
    FixtureForce guide_;         // of the turbine
    bool silent_ = true;
};

}  // namespace tactooth

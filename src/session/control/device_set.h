// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "devices/base/haptic_device.h"
#include "haptics/force_pipeline.h"
#include "session/control/button_actions.h"
#include "session/control/device_mapping.h"

namespace tactooth {

/// What a person sets about the hands while the simulation runs.
struct DeviceControls {
    bool clutch = false;       ///< the instruments stay where they are while the hands move on
    double motionScaling = 1;  ///< mm that a hand moves for each mm of its instrument
    ButtonMap buttons = {};
};

/// The one or two hands of a person, each with a device, and the two instruments, turbine and mirror. The first hand
/// begins with the turbine, a second one with the mirror. A swap makes two hands exchange what they hold; a single hand
/// lays the one down and takes up the other. An instrument that goes from hand to hand does not move: the new hand
/// takes it where it is. While a device is lost or its pose is at fault, its instrument stays where the tooth holds it,
/// so that it neither presses nor cuts. Each device has a force pipeline of its own, so a force never changes hands: it
/// fades in the one, and the other feels nothing before the bur has been free. All of the servo thread; allocates and
/// locks nothing.
class DeviceSet {
public:
    /// The devices are open and outlive this. `second`: nullptr for a single hand. `registration`: for a device whose
    /// frame has nothing to do with the tooth; without it the first device's frame is the tooth's.
    DeviceSet(HapticDevice& first, HapticDevice* second, const std::optional<DeviceRegistration>& registration);
    DeviceSet(const DeviceSet&) = delete;
    DeviceSet& operator=(const DeviceSet&) = delete;

    /// Reads the devices and moves the instruments.
    void read(double elapsed, const DeviceControls& controls);

    /// Of the turbine in the tooth; no number before a hand was read that holds it.
    [[nodiscard]] const Pose& turbine() const { return instruments_[kTurbine]; }
    /// How the mirror was moved since the start.
    [[nodiscard]] const Pose& mirror() const { return instruments_[kMirror]; }
    /// Whether a button has turned touch into cut, or back.
    [[nodiscard]] bool cutToggled() const;
    /// 0 .. 1: the deeper of the feet.
    [[nodiscard]] double pedal() const;
    /// s since the hand with the turbine was measured; 0 if none holds it.
    [[nodiscard]] double age() const;
    /// Of the device whose hand holds the turbine, N/mm; no bound if none does.
    [[nodiscard]] double maxStiffness() const;

    /// Sends each device its force: to the hand with the turbine what the tick wants, to the other one none.
    void write(const Tick& tick, bool enabled, double elapsed);

    /// Why the hand that holds the turbine feels what it feels.
    [[nodiscard]] ForceState forceState() const;
    /// Whether a hand has come to the end of its device's room, as far as that is known: the clutch takes it further.
    [[nodiscard]] bool isAtWorkspaceLimit() const;
    /// Whether no device makes a force.
    [[nodiscard]] bool isSilent() const { return silent_; }

private:
    static constexpr std::size_t kTurbine = 0;
    static constexpr std::size_t kMirror = 1;
    static constexpr int kNoHolder = -1;

    struct DeviceSlot {
        DeviceSlot(HapticDevice& held, const std::optional<DeviceRegistration>& turbineRegistration,
                   const DeviceRegistration& mirrorRegistration);
        HapticDevice* device;
        ForcePipeline pipeline;
        std::array<DeviceMapping, 2> frames;  // of turbine and mirror
        ButtonActions buttons;
        DeviceSample sample;
        bool poseValid = false;         // the device is there, and nothing is wrong with its pose
        bool atWorkspaceLimit = false;  // of the device's room, while it holds something
    };
    [[nodiscard]] int holderOf(std::size_t instrument) const;
    [[nodiscard]] bool swapped() const;
    void move(std::size_t instrument, const DeviceControls& controls);
    void rest(std::size_t instrument);
    [[nodiscard]] ForceCommand wantedFor(const DeviceSlot& hand, const Tick& tick, bool enabled) const;

    std::optional<DeviceSlot> first_;
    std::optional<DeviceSlot> second_;
    std::array<DeviceSlot*, 2> devices_;  // none, or the two above
    std::array<int, 2> holders_ = {0, kNoHolder};
    /// Nowhere, until a hand was read; the mirror where it was parked.
    std::array<Pose, 2> instruments_{Pose{Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), Quat::Identity()},
                                     Pose{}};
    std::optional<Pose> proxy_;  // of the turbine at the last tick
    bool silent_ = true;
};

}  // namespace tactooth

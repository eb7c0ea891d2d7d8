// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "devices/base/workspace_fit.h"
#include "devices/mouse/mouse_device.h"
#include "geometry/util/message.h"
#include "session/control/device_mapping.h"

namespace tactooth {

enum class DeviceSlot {
    First,  ///< the hand that moves the tool; the mouse moves it while the slot is empty
    Second  ///< the other hand, which begins with the mirror
};

/// The open devices of both hands, and the mouse that takes the place of the first one.
class DeviceSlots {
public:
    /// `start`: pose of the tool that the mouse begins with, tooth frame.
    explicit DeviceSlots(const Pose& start) : mouse_(start) {}

    /// Puts an open device into a slot, null: empties it. The device before is closed. No runner may use it.
    void set(DeviceSlot slot, std::unique_ptr<HapticDevice> device);
    /// Null: the mouse moves the tool.
    [[nodiscard]] const HapticDevice* first() const { return first_.get(); }
    /// Null: that hand is empty.
    [[nodiscard]] HapticDevice* second() const { return second_.get(); }
    /// The device that moves the tool: the first one or the mouse.
    [[nodiscard]] HapticDevice& active() { return first_ ? *first_ : mouse_; }
    /// Moves the mouse's hand, tooth frame.
    void moveMouse(const Pose& hand) { mouse_.moveTo({hand, 0, 0, true}); }
    /// See HapticDevice::suspendInput; for the first device.
    void suspendInput(bool suspended);

    /// The fault message of a device, null for none, if it differs from that of the last call.
    [[nodiscard]] std::optional<const Message*> changedFault();

    /// The motion scaling with which the devices reach all of `workspace` (a box in the tooth's frame); none without a
    /// first device, or if no device has a bounded workspace. `deviceInTooth`: see deviceRotation.
    [[nodiscard]] std::optional<WorkspaceFit> fit(const Box3& workspace, const Quat& deviceInTooth) const;
    /// How the first device takes the tool that is at `tool`; none for a device in the tooth's frame and for the mouse.
    /// `fitted`: the centre of the device's workspace, where it is known, lies at the centre of `workspace`.
    [[nodiscard]] std::optional<DeviceRegistration> registration(const Pose& tool, const Box3& workspace,
                                                                 const Quat& deviceInTooth, bool fitted) const;

private:
    MouseDevice mouse_;
    std::unique_ptr<HapticDevice> first_;   // null: the mouse
    std::unique_ptr<HapticDevice> second_;  // null: one hand only
    const Message* reportedFault_ = nullptr;
};

/// From a device's frame to the tooth's: the device's +y ("away") is the direction in which the dentist looks at the
/// tooth. `mesialX`: direction of mesial along x.
[[nodiscard]] Quat deviceRotation(double mesialX);

/// What a hand should reach with the tool: the box of the tooth with the margin around it that the mouse has too.
[[nodiscard]] Box3 handWorkspace(const Box3& tooth);

}  // namespace tactooth

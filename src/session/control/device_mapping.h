// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/pose.h"
#include "haptics/wrench.h"

namespace tactooth {

/// Registration of a device with a tool that has a frame of its own.
struct DeviceRegistration {
    Pose tool;  ///< pose of the tool in the tooth frame at the first device reading, or when the device is at `hand`
    Quat turn = Quat::Identity();   ///< from the device's frame into the tooth's: the direction of the device's "right"
    std::optional<Vec3> hand = {};  ///< device position for `tool`, in the device's frame; none: the first reading
};

/// Mapping of a device's frame to the tooth's: rotation, offset and motion scaling. The clutch lets the user move the
/// device back to a comfortable position while the tool stays, like lifting a mouse at the edge of its pad. No change
/// of these settings moves the tool.
class DeviceMapping {
public:
    /// Without a registration, tool pose and device pose are equal until a setting changes.
    explicit DeviceMapping(const std::optional<DeviceRegistration>& registration = {}) : registration_(registration) {}

    /// While the clutch is held, the tool stays.
    void setClutch(bool held) { held_ = held; }
    [[nodiscard]] bool isHeld() const { return held_; }
    /// From the next reading on the device holds the tool, which is at `tool`, wherever the device is: used when
    /// another device hands the tool over.
    void takeOver(const Pose& tool);
    /// mm of the device for each mm of the tool; 1 replaces an invalid value.
    void setMotionScaling(double motionScaling);
    [[nodiscard]] double motionScaling() const { return motionScaling_; }

    /// Pose of the tool in the tooth frame for the newest device pose. An invalid pose (not a number) is passed on
    /// unchanged.
    [[nodiscard]] Pose toolFor(const Pose& hand);

    /// Converts a wrench from the tooth frame to the device's frame. Forces are not scaled: the device renders the
    /// force that acts on the tool.
    [[nodiscard]] Wrench toDevice(const Wrench& inTooth) const;

private:
    void registerAt(const Pose& hand, const Pose& tool);
    [[nodiscard]] Quat turn() const { return registration_ ? registration_->turn : Quat::Identity(); }

    std::optional<DeviceRegistration> registration_;
    bool isIdentity_ = true;  // tool pose and device pose are equal
    bool held_ = false;
    bool wasHeld_ = false;
    double motionScaling_ = 1;
    double registeredMotionScaling_ = 1;
    Vec3 deviceOrigin_ = Vec3::Zero();
    Vec3 toolOrigin_ = Vec3::Zero();
    Quat toolInDevice_ = Quat::Identity();  // orientation of the tool relative to the device
    std::optional<Pose> last_;              // last pose of the tool
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/pose.h"
#include "haptics/wrench.h"

namespace tactooth {

/// How a hand takes a tool that has a frame of its own.
struct DeviceRegistration {
    Pose tool;                     ///< where the tool is in the tooth's frame when the hand is first read, or at `hand`
    Quat turn = Quat::Identity();  ///< from the device's frame into the tooth's: where the hand's "right" is
    std::optional<Vec3> hand =
        {};  ///< where it has to be for that, in the device's frame; none: where it happens to be
};

/// How a device's frame lies in the tooth's: turned, moved, and finer or not. The clutch lets the hand go back to a
/// comfortable place while the tool stays, as one lifts a mouse at the edge of its pad; nothing that changes here moves
/// the tool.
class DeviceMapping {
public:
    /// Without a seat, tool and hand are the same until something changes.
    explicit DeviceMapping(const std::optional<DeviceRegistration>& registration = {}) : registration_(registration) {}

    /// While held, the tool stays where it is.
    void setClutch(bool held) { held_ = held; }
    [[nodiscard]] bool isHeld() const { return held_; }
    /// From the next reading on the hand holds the tool that is at `tool`, wherever the hand is: another one hands it
    /// over.
    void takeOver(const Pose& tool);
    /// mm of the hand for each mm of the tool; 1 for anything that is no such number.
    void setMotionScaling(double motionScaling);
    [[nodiscard]] double motionScaling() const { return motionScaling_; }

    /// Of the tool in the tooth, for the device's newest reading. A reading that is no number is handed on as it is.
    [[nodiscard]] Pose toolFor(const Pose& hand);

    /// A wrench in the tooth's frame, as the device's motors have to make it. Forces are not scaled: what is felt at
    /// the tool is felt by the hand.
    [[nodiscard]] Wrench toDevice(const Wrench& inTooth) const;

private:
    void registerAt(const Pose& hand, const Pose& tool);
    [[nodiscard]] Quat turn() const { return registration_ ? registration_->turn : Quat::Identity(); }

    std::optional<DeviceRegistration> registration_;
    bool isIdentity_ = true;  // tool and hand are the same
    bool held_ = false;
    bool wasHeld_ = false;
    double motionScaling_ = 1;
    double registeredMotionScaling_ = 1;
    Vec3 deviceOrigin_ = Vec3::Zero();
    Vec3 toolOrigin_ = Vec3::Zero();
    Quat toolInDevice_ = Quat::Identity();  // of the tool in the hand
    std::optional<Pose> last_;              // of the tool
};

}  // namespace tactooth

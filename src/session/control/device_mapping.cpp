// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/device_mapping.h"

#include <cmath>

namespace tactooth {

void DeviceMapping::setMotionScaling(double motionScaling) {
    motionScaling_ = std::isfinite(motionScaling) && motionScaling > 0 ? motionScaling : 1;
}

/// From now on, the device pose `hand` corresponds to the tool pose `tool`.
void DeviceMapping::registerAt(const Pose& hand, const Pose& tool) {
    isIdentity_ = false;
    deviceOrigin_ = hand.position;
    toolOrigin_ = tool.position;
    toolInDevice_ = ((turn() * hand.rotation).conjugate() * tool.rotation).normalized();
    registeredMotionScaling_ = motionScaling_;
}

void DeviceMapping::takeOver(const Pose& tool) {
    last_ = tool;
    wasHeld_ = true;
}

Pose DeviceMapping::toolFor(const Pose& hand) {
    if (!hand.position.allFinite() || !hand.rotation.coeffs().allFinite()) return hand;
    if (!last_ && registration_)
        registerAt({registration_->hand.value_or(hand.position), hand.rotation}, registration_->tool);
    if (last_ && held_) {
        wasHeld_ = true;
        return *last_;
    }
    if (last_ && (wasHeld_ || motionScaling_ != registeredMotionScaling_)) registerAt(hand, *last_);
    wasHeld_ = false;
    last_ = isIdentity_ ? hand
                        : Pose{toolOrigin_ + turn() * (hand.position - deviceOrigin_) / registeredMotionScaling_,
                               (turn() * hand.rotation * toolInDevice_).normalized()};
    return *last_;
}

Wrench DeviceMapping::toDevice(const Wrench& inTooth) const {
    const Quat back = turn().conjugate();
    return {back * inTooth.force, back * inTooth.torque};
}

}  // namespace tactooth

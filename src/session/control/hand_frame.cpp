// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/hand_frame.h"

#include <cmath>

namespace tactooth {

void HandFrame::setFineness(double fineness) { fineness_ = std::isfinite(fineness) && fineness > 0 ? fineness : 1; }

/// From now on, the hand at `hand` holds the tool at `tool`.
void HandFrame::sit(const Pose& hand, const Pose& tool) {
    plain_ = false;
    handOrigin_ = hand.position;
    toolOrigin_ = tool.position;
    grip_ = ((turn() * hand.rotation).conjugate() * tool.rotation).normalized();
    seatedFineness_ = fineness_;
}

void HandFrame::takeOver(const Pose& tool) {
    last_ = tool;
    wasHeld_ = true;
}

Pose HandFrame::toolFor(const Pose& hand) {
    if (!hand.position.allFinite() || !hand.rotation.coeffs().allFinite()) return hand;
    if (!last_ && seat_) sit({seat_->hand.value_or(hand.position), hand.rotation}, seat_->tool);
    if (last_ && held_) {
        wasHeld_ = true;
        return *last_;
    }
    if (last_ && (wasHeld_ || fineness_ != seatedFineness_)) sit(hand, *last_);
    wasHeld_ = false;
    last_ = plain_ ? hand
                   : Pose{toolOrigin_ + turn() * (hand.position - handOrigin_) / seatedFineness_,
                          (turn() * hand.rotation * grip_).normalized()};
    return *last_;
}

Wrench HandFrame::toDevice(const Wrench& inTooth) const {
    const Quat back = turn().conjugate();
    return {back * inTooth.force, back * inTooth.torque};
}

}  // namespace tactooth

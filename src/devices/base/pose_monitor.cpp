// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/pose_monitor.h"

#include "devices/base/messages.h"

namespace tactooth {
namespace {

// Made before the servo runs, which only hands their places on.
const Message kNotANumber(msg::kPoseNotANumber);
const Message kInvalidRotation(msg::kPoseInvalidRotation);
const Message kJump(msg::kPoseJump);
const Message kTooFast(msg::kPoseTooFast);
const Message kRotatesTooFast(msg::kPoseRotatesTooFast);
const Message kStale(msg::kPoseStale);
const Message kForce(msg::kPoseForce);

}  // namespace

const Message* poseFaultMessage(PoseFault fault) {
    switch (fault) {
        case PoseFault::None:
            return nullptr;
        case PoseFault::NotANumber:
            return &kNotANumber;
        case PoseFault::InvalidRotation:
            return &kInvalidRotation;
        case PoseFault::Jump:
            return &kJump;
        case PoseFault::TooFast:
            return &kTooFast;
        case PoseFault::RotatesTooFast:
            return &kRotatesTooFast;
        case PoseFault::Stale:
            return &kStale;
        case PoseFault::Force:
            return &kForce;
    }
    return nullptr;
}

}  // namespace tactooth

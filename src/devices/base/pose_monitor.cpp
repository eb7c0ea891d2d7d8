// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/pose_monitor.h"

namespace tactooth {

const char* poseFaultText(PoseFault fault) {
    switch (fault) {
        case PoseFault::None:
            return nullptr;
        case PoseFault::NotANumber:
            return "The device tells a place that is no number: switch it off and on again if this comes again.";
        case PoseFault::InvalidRotation:
            return "The device tells a direction that is none: switch it off and on again if this comes again.";
        case PoseFault::Jump:
            return "The device's place has jumped: check its cable, and let it calibrate if this comes again.";
        case PoseFault::TooFast:
            return "The device moved faster than 1.5 m/s at the tooth, so its force is off: lift the bur, and check "
                   "the "
                   "cable if the hand was slow.";
        case PoseFault::RotatesTooFast:
            return "The device's direction has jumped: switch it off and on again if this comes again.";
        case PoseFault::Stale:
            return "The device's places come too late: close other programs that keep this machine busy.";
        case PoseFault::Force:
            return "The force came out as no number and was switched off: lift the bur, and report it to the authors "
                   "if "
                   "this comes again.";
    }
    return nullptr;
}

}  // namespace tactooth

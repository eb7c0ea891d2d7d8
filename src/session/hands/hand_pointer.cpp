// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/hand_pointer.h"

namespace tactooth {

void HandPointer::aim(MouseManipulator& hand, const Sight& sight, const Vec2& pixel) {
    inMirror_ = sight.glass && showsGlass(sight.picture, pixel, *sight.glass, sight.mouth);
    if (!inMirror_) return hand.aim(sight.picture, pixel, sight.mouth);
    hand.aim(MirrorView(sight.picture, *sight.glass), pixel, sight.mouth);
}

void HandPointer::press(MouseManipulator& hand, const Sight& sight, const Vec2& pixel) {
    inMirror_ = sight.glass && showsGlass(sight.picture, pixel, *sight.glass, sight.mouth);
    if (!inMirror_) return hand.press(sight.picture, pixel);
    hand.press(MirrorView(sight.picture, *sight.glass), pixel);
}

void HandPointer::drag(MouseManipulator& hand, const Sight& sight, const Vec2& pixel) const {
    if (!inMirror_) return hand.drag(sight.picture, pixel);
    const bool isOnGlass = sight.glass && meetingWith(*sight.glass, sight.picture.rayThrough(pixel));
    if (isOnGlass) hand.drag(MirrorView(sight.picture, *sight.glass), pixel);
}

void HandPointer::tilt(MouseManipulator& hand, const Sight& sight, const Vec2& pixels) const {
    if (!inMirror_ || !sight.glass) return hand.tilt(sight.picture, pixels);
    hand.tilt(MirrorView(sight.picture, *sight.glass), pixels);
}

}  // namespace tactooth

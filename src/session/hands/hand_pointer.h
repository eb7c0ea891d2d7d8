// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "session/hands/mirror_view.h"
#include "session/hands/mouse_manipulator.h"

namespace tactooth {

/// Leads the mouse's hand by what the mouse points at: the tooth itself, or, where the picture shows the glass of the
/// mouth mirror, the tooth in the mirror. There the tip follows its image. A press that has begun in the mirror stays
/// in it: beside the glass the hand waits.
class HandPointer {
public:
    /// What the picture shows. Null `glass`: no mirror.
    struct Sight {
        const PointerView& picture;
        std::optional<MirrorDisc> glass;
        const Surface& mouth;  ///< all that can hide something, and that the tool can touch
    };

    // As those of MouseManipulator.
    void aim(MouseManipulator& hand, const Sight& sight, const Vec2& pixel);
    void press(MouseManipulator& hand, const Sight& sight, const Vec2& pixel);
    void drag(MouseManipulator& hand, const Sight& sight, const Vec2& pixel) const;
    /// Leans the shaft as it is seen where the hand points.
    void tilt(MouseManipulator& hand, const Sight& sight, const Vec2& pixels) const;

    /// Whether the hand points into the mirror.
    [[nodiscard]] bool isInMirror() const { return inMirror_; }

private:
    bool inMirror_ = false;
};

}  // namespace tactooth

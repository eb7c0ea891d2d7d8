// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/gui/input/viewport.h"

namespace tactooth {

class SessionModel;

/// Lets one mouse hold two instruments: while a key is down it moves the mouth mirror, and the bur stays as it is.
class MirrorMouse {
public:
    /// `model` outlives it.
    explicit MirrorMouse(SessionModel& model) : model_(model) {}

    /// The key goes down or up. True if that changes anything.
    bool hold(bool held);
    [[nodiscard]] bool isHeld() const { return held_; }

    /// The mouse moves between two pixels: the glass follows it; or, if it `tilts`, turns to where
    /// the mouse goes.
    void move(const Viewport& picture, const Vec2& from, const Vec2& to, bool tilts);
    /// The glass comes nearer to the eye, mm.
    void approach(const Viewport& picture, double distance);

    /// Holds the mirror where it shows the bur from behind. False if there is no such place, or nothing to look at.
    [[nodiscard]] bool placeBehindBur(const Viewport& picture);
    /// Holds the mirror where it shows the chewing surface or the edge of the tooth to the eye. False as above.
    [[nodiscard]] bool placeOverCrown(const Viewport& picture);
    /// Back to where it waits.
    void park();

private:
    [[nodiscard]] bool place(const std::optional<Pose>& found);

    SessionModel& model_;
    bool held_ = false;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"
#include "geometry/util/pose.h"
#include "session/model/pointer_view.h"

namespace tactooth {

/// Moves the tool by the mouse. With the button up the user aims: the tool hovers over the point of the tooth under the
/// mouse pointer. With the button down the tool approaches that point and presses. The hand then stays a fixed depth
/// beyond the tool, which makes a steady force. The hand sinks as the tooth is removed, and follows the mouse sideways.
/// A tool that is caught in its cavity when the user aims elsewhere first retracts along its shaft.
class MouseManipulator {
public:
    /// The hand starts above the middle of `tooth` (its box, tooth frame). `mesialX`: direction of mesial along x.
    MouseManipulator(const Box3& tooth, double mesialX);

    /// The button is up and the mouse is at `pixel`.
    void aim(const PointerView& picture, const Vec2& pixel, const Surface& surface);
    /// The button goes down, the mouse moves while it is down, the button goes up.
    void press(const PointerView& picture, const Vec2& pixel);
    void drag(const PointerView& picture, const Vec2& pixel);
    void release();

    /// Moves the hand for the next `dt` seconds. `toolTip`: the tip of the proxy; `depth`: from the proxy to the hand,
    /// mm. Both come from the newest tick.
    void advance(double dt, const Vec3& toolTip, double depth);

    /// How far the hand presses beyond the tool, mm. With a spring of 1 N/mm this is the force in N.
    void setPressDepth(double depth);
    [[nodiscard]] double pressDepth() const { return pressDepth_; }
    static constexpr double kWorkspaceMargin = 6;  // mm around the tooth's box in which the hand stays
    static constexpr double kMaxPressDepth = 3;    // mm: 3 N on enamel, the most that a desk-top device renders

    /// Tilts the shaft by (dx, dy) pixels as seen in the picture; the tip stays.
    void tilt(const PointerView& picture, const Vec2& pixels);
    /// Turns handle and shaft about the vertical axis through the tip, rad.
    void rotateHandle(double angle);
    void resetOrientation();

    [[nodiscard]] Pose pose() const { return {tip_, handle_}; }
    [[nodiscard]] bool isPressing() const { return pressing_; }
    /// Direction of pressing: unit, tooth frame.
    [[nodiscard]] const Vec3& pressDirection() const { return pressDirection_; }

private:
    void advanceContact(double dt, const Vec3& toolTip);
    void retract(double dt, const Vec3& toolTip);
    [[nodiscard]] Vec3 clampedToWorkspace(const Vec3& tip) const;
    [[nodiscard]] Vec3 onPlane(const PointerView& picture, const Vec2& pixel) const;
    void choosePressDirection(const PointerView& picture);

    Box3 tooth_;
    double mesialX_;
    Vec3 tip_;
    Vec3 pressDirection_ = -Vec3::UnitZ();
    Quat handle_;
    double pressDepth_ = 1;
    bool pressing_ = false;
    bool retracting_ = false;
    bool mayRetract_ = true;  // once for each point aimed at: the tool may be unable to reach it
    Vec3 aimedAt_;
    Vec2 grabbed_ = Vec2::Zero();
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/bvh/surface.h"
#include "view/camera/camera.h"

namespace tactooth {

/// The picture that the mouse points into.
struct Viewport {
    Camera camera;
    ImageSize size;
};

/// How a mouse becomes a hand that holds a drill. With the button up the tool aims: it hovers over the point of the
/// tooth under the mouse. With the button down it goes down on that point and presses: the hand stays a chosen depth
/// beyond the tool's own place, as a hand with a steady force does, sinks as the tooth gives way, and follows the mouse
/// sideways. A tool that is caught in its own cavity when the hand aims elsewhere is first drawn out along its shaft.
/// Knows no widgets.
class MouseManipulator {
public:
    /// Rests above the middle of `tooth` (its box, tooth frame). `mesialX`: direction of mesial along x.
    MouseManipulator(const Box3& tooth, double mesialX);

    /// Button up, mouse at `pixel`.
    void aim(const Viewport& picture, const Vec2& pixel, const Surface& surface);
    /// Button goes down, moves while down, goes up.
    void press(const Viewport& picture, const Vec2& pixel);
    void drag(const Viewport& picture, const Vec2& pixel);
    void release();

    /// Lets `dt` seconds pass. `toolTip`: where the tooth lets the tool be, `depth`: how far the hand is beyond it, mm,
    /// as the newest tick says.
    void advance(double dt, const Vec3& toolTip, double depth);

    /// How deep the hand presses beyond the tool, mm: with a spring of 1 N/mm, N.
    void setPressDepth(double depth);
    [[nodiscard]] double pressDepth() const { return pressDepth_; }
    static constexpr double kWorkspaceMargin = 6;  // mm around the tooth's box in which the hand stays
    static constexpr double kMaxPressDepth = 3;    // mm: 3 N on enamel, the most that a desk-top device renders

    /// Leans the tool's shaft by (dx, dy) pixels as seen in the picture; the tip stays.
    void tilt(const Viewport& picture, const Vec2& pixels);
    /// Turns handle and shaft about the tip's upright axis, rad.
    void rotateHandle(double angle);
    void resetOrientation();

    [[nodiscard]] Pose pose() const { return {tip_, handle_}; }
    [[nodiscard]] bool isPressing() const { return pressing_; }
    /// Unit, tooth frame: the way that pressing goes.
    [[nodiscard]] const Vec3& pressDirection() const { return pressDirection_; }

private:
    void advanceContact(double dt, const Vec3& toolTip);
    void retract(double dt, const Vec3& toolTip);
    [[nodiscard]] Vec3 clampedToWorkspace(const Vec3& tip) const;
    [[nodiscard]] Vec3 onPlane(const Viewport& picture, const Vec2& pixel) const;
    void choosePressDirection(const Viewport& picture);

    Box3 tooth_;
    double mesialX_;
    Vec3 tip_;
    Vec3 pressDirection_ = -Vec3::UnitZ();
    Quat handle_;
    double pressDepth_ = 1;
    bool pressing_ = false;
    bool retracting_ = false;
    bool mayRetract_ = true;  // once for each place that is aimed at: there may be no way to it
    Vec3 aimedAt_;
    Vec2 grabbed_ = Vec2::Zero();
};

}  // namespace tactooth

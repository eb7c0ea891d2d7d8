// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/util/pose.h"
#include "session/control/clear_travel.h"
#include "session/control/depth_control.h"
#include "session/hands/pointer_view.h"

namespace tactooth {

/// What ends the press of the mouse.
enum class PressMode {
    Depth,  ///< the tip is at the set depth below the uncut surface
    Force,  ///< nothing: the hand presses with a steady force and sinks as long as the tooth gives way
};

/// Moves the tool by the mouse. With the button up the user aims: the tool hovers over the point of the tooth under the
/// mouse pointer, clear of everything. With the button down the tool approaches that point and presses, with a steady
/// force, until the tip is as deep as was set (see PressMode); it follows the mouse sideways. With the button up again
/// it leaves along its shaft, or as it came where an edge holds it, before it goes anywhere else.
class MouseManipulator {
public:
    /// The hand starts above the middle of `tooth` (its box, tooth frame). `mesialX`: direction of mesial along x.
    MouseManipulator(const Box3& tooth, double mesialX);

    /// What the hand knows of the scene: what the tool could touch now, the tool, and the uncut surface of the tooth.
    /// Null: nothing is known of it, and the hand goes straight; a tool that is caught is drawn out along its shaft.
    struct Surroundings {
        std::shared_ptr<const Surface> touchable;
        std::shared_ptr<const ToolShape> tool;
        std::shared_ptr<const SurfacePart> uncut;
    };
    void setSurroundings(const Surroundings& surroundings);
    [[nodiscard]] const Surroundings& surroundings() const { return surroundings_; }

    /// The button is up and the mouse is at `pixel`.
    void aim(const PointerView& picture, const Vec2& pixel, const Surface& surface);
    /// The button goes down, the mouse moves while it is down, the button goes up.
    void press(const PointerView& picture, const Vec2& pixel);
    void drag(const PointerView& picture, const Vec2& pixel);
    void release();

    /// Moves the hand for the next `dt` seconds. `toolTip`: the tip of the proxy; `depth`: from the proxy to the hand,
    /// mm. Both come from the newest tick.
    void advance(double dt, const Vec3& toolTip, double depth);

    void setPressMode(PressMode mode) { mode_ = mode; }
    /// PressMode::Force while a hand instrument is held: nobody sets how deep a probe goes.
    [[nodiscard]] PressMode pressMode() const { return holdsHandInstrument_ ? PressMode::Force : mode_; }
    /// As it was set.
    [[nodiscard]] PressMode chosenPressMode() const { return mode_; }
    void setHoldsHandInstrument(bool holds) { holdsHandInstrument_ = holds; }
    /// The depth at which PressMode::Depth ends, and its floor.
    [[nodiscard]] DepthControl& depthControl() { return depthControl_; }
    [[nodiscard]] const DepthControl& depthControl() const { return depthControl_; }
    /// How far the hand presses beyond the tool, mm. With a spring of 1 N/mm this is the force in N.
    void setPressDepth(double depth);
    [[nodiscard]] double pressDepth() const { return pressDepth_; }
    static constexpr double kUsualPressDepth = 0.4;  ///< mm: as a dentist presses a turbine
    static constexpr double kWorkspaceMargin = 6;    // mm around the tooth's box in which the hand stays
    static constexpr double kMaxPressDepth = 3;      // mm: 3 N on enamel, the most that a desk-top device renders

    /// Tilts the shaft by (dx, dy) pixels as seen in the picture; the tip stays.
    void tilt(const PointerView& picture, const Vec2& pixels);
    /// Turns handle and shaft about the vertical axis through the tip, rad.
    void rotateHandle(double angle);
    void resetOrientation();
    /// Holds the shaft along `outward`, unit, out of the tooth.
    void alignShaft(const Vec3& outward);

    [[nodiscard]] Pose pose() const { return {tip_, grip_}; }
    [[nodiscard]] bool isPressing() const { return pressing_; }
    /// Whether a running bur may cut: not from the end of a press until the tool has left the tooth, and not while
    /// something holds a tool that travels.
    [[nodiscard]] bool mayCut() const { return (pressing_ && arrived_) || !(withdraws_ || caught_); }
    /// Direction of pressing: unit, tooth frame.
    [[nodiscard]] const Vec3& pressDirection() const { return pressDirection_; }
    /// The place of the tooth under the mouse pointer, where the tip lands; none beside the tooth.
    [[nodiscard]] const std::optional<Vec3>& landing() const { return landing_; }

private:
    [[nodiscard]] bool knowsScene() const {
        return surroundings_.touchable != nullptr && surroundings_.tool != nullptr;
    }
    void noteTrail(const Vec3& toolTip);
    [[nodiscard]] bool retrace(double dt, const Vec3& toolTip, double depth);
    void travel(double dt, const Vec3& toolTip, double depth);
    [[nodiscard]] bool isOverLanding(const Vec3& toolTip) const;
    void advanceContact(double dt, const Vec3& toolTip);
    void advanceToDepth(double dt, const Vec3& toolTip);
    [[nodiscard]] double toFloor(const Vec3& toolTip, const Vec3& aside);
    void retract(double dt, const Vec3& toolTip);
    [[nodiscard]] Vec3 clampedToWorkspace(const Vec3& tip) const;
    [[nodiscard]] Vec3 onPlane(const PointerView& picture, const Vec2& pixel) const;
    [[nodiscard]] bool pressesToDepth() const {
        return pressMode() == PressMode::Depth && surroundings_.uncut != nullptr;
    }
    void choosePressDirection(const PointerView& picture);
    void hold(const Quat& handle);
    void noteLanding(const PointerView& picture, const Vec2& pixel, const Surface& surface);

    Box3 tooth_;
    double mesialX_;
    Surroundings surroundings_;
    DepthControl depthControl_;
    ClearTravel travel_;
    PressMode mode_ = PressMode::Depth;
    bool holdsHandInstrument_ = false;
    Vec3 tip_;
    Vec3 pressDirection_ = -Vec3::UnitZ();
    Quat handle_;  // as the user holds it
    Quat grip_;    // as it is held now: on the way to handle_
    double pressDepth_ = kUsualPressDepth;
    bool pressing_ = false;
    bool arrived_ = false;     // the pressing tool is over its landing place
    bool leaving_ = false;     // the button has gone up, and the tool has not begun to leave
    bool withdraws_ = false;   // the button has gone up, and the tool is not clear of everything yet
    bool caught_ = false;      // something holds the tool away from a hand that does not press
    bool retraces_ = false;    // it could not leave along its shaft: it goes back as it came
    double waits_ = 0;         // s without progress on that path
    int catches_ = 0;          // since the button went up: times that something has caught the tool
    std::vector<Pose> trail_;  // of the pressed tool, without loops
    bool retracting_ = false;
    bool mayRetract_ = true;  // once for each point aimed at: the tool may be unable to reach it
    Vec3 aimedAt_;
    std::optional<Vec3> landing_;
    std::optional<double> floorAlong_;  // of the last place with a depth: where its floor is along pressDirection_
    Vec2 grabbed_ = Vec2::Zero();
};

}  // namespace tactooth

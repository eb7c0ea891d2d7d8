// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mouth mirror in the picture: where it is, and the hand that works by it.
#include "app/gui/scene/session_scene.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {

std::optional<MirrorDisc> ToothView::glass() const {
    return showsMirror_ && !contents_ && tool_ == nullptr ? mirrorGlass(model_) : std::nullopt;
}

MirrorSight ToothView::mirrorSight() const {
    const std::optional<MirrorDisc> shown = glass();
    if (!shown) return {};
    return MirrorSight::of(mirrorPose(model_), shown->radius, viewport().camera().cameraInWorld.position);
}

void ToothView::pressHand() {
    const Viewport picture = viewport();
    if (model_.runner() == nullptr) return model_.manipulator().press(picture, mouse_);
    const auto mouth = touchableSurface(model_);
    pointer_.press(model_.manipulator(), {picture, glass(), *mouth}, mouse_);
}

void ToothView::pointHand(const Vec2& displacement, bool leans) {
    const Viewport picture = viewport();
    const auto mouth = touchableSurface(model_);
    const HandPointer::Sight sight{picture, glass(), *mouth};
    MouseManipulator& hand = model_.manipulator();
    if (leans) {
        pointer_.tilt(hand, sight, displacement);
    } else if (hand.isPressing()) {
        pointer_.drag(hand, sight, mouse_);
    } else {
        pointer_.aim(hand, sight, mouse_);
    }
}

std::optional<Ray> ToothView::alongTip() const {
    const Pose& tool = model_.log().newest().contact.proxy;
    if (model_.devices().first() == nullptr || !tool.position.allFinite()) return std::nullopt;
    constexpr double kBack = 1;  // mm up the shaft: the tip may touch
    const Vec3 shaft = tool.rotation * Vec3::UnitZ();
    return Ray{tool.position + kBack * shaft, -shaft};
}

void ToothView::markAtTip() {
    const auto ray = isMeasuring() ? alongTip() : std::nullopt;
    if (ray) measure_->pick(*touchableSurface(model_), model_.tooth()->piece->tooth(), viewport(), *ray);
}

void ToothView::holdMirror(bool held) {
    if (!mirrorMouse_.hold(held)) return;
    showCursor();
    if (held) emit mirrorUsed();
}

void ToothView::placeMirror() {
    if (contents_) return;
    if (!mirrorMouse_.placeBehindBur(viewport())) return emit mirrorNotPlaced();
    emit mirrorUsed();
    redraw();
}

void ToothView::takeDentistView() {
    resetView();
    if (contents_ || !model_.tooth()) return;
    const ChairView chair = chairViewOf(*model_.tooth());
    if (chair.mirror) {
        if (!mirrorMouse_.placeOverCrown(viewport())) return emit mirrorNotPlaced();
        emit mirrorUsed();
    }
    if (chair.clock != 0) emit dentistViewTaken(chair.clock, chair.mirror);
    redraw();
}

void ToothView::moveMirror(const Vec2& displacement, bool tilts) {
    if (contents_ || model_.runner() == nullptr) return;
    const ImageSize size = pictureSize(*this);
    // From the middle: the glass goes as far wherever it is.
    const Vec2 from(size.width / 2.0, size.height / 2.0);
    mirrorMouse_.move(viewport(), from, from + size.height * displacement, tilts);
    emit mirrorUsed();
    redraw();
}

void ToothView::approachMirror(double distance) {
    if (contents_ || model_.runner() == nullptr) return;
    mirrorMouse_.approach(viewport(), distance);
    emit mirrorUsed();
    redraw();
}

void ToothView::parkMirror() {
    mirrorMouse_.park();
    redraw();
}

void ToothView::takeParkedMirror() {
    parkMirror();
    emit mirrorUsed();
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input/mirror_mouse.h"

#include <utility>

#include "session/hands/mirror_aim.h"
#include "session/model/session_model.h"

namespace tactooth {
namespace {

/// Without the bur. Needs the meshes of the instruments.
MirrorAim aimOf(const SessionModel& model, const Viewport& picture) {
    return {.tip = Vec3::Zero(),
            .shaft = Vec3::UnitZ(),
            .eye = picture.camera().cameraInWorld.position,
            .handle = -handleX(model) * Vec3::UnitX(),
            .radius = model.instruments().meshes()->disc.radius};
}

}  // namespace

bool MirrorMouse::hold(bool held) { return std::exchange(held_, held) != held; }

void MirrorMouse::move(const Viewport& picture, const Vec2& from, const Vec2& to, bool tilts) {
    if (tilts) {
        model_.mirror().tilt(picture, to - from);
    } else {
        model_.mirror().drag(picture, from, to);
    }
}

void MirrorMouse::approach(const Viewport& picture, double distance) { model_.mirror().approach(picture, distance); }

bool MirrorMouse::placeBehindBur(const Viewport& picture) {
    if (model_.runner() == nullptr || !model_.instruments().meshes()) return false;
    const Pose& bur = model_.log().newest().contact.proxy;
    if (!bur.position.allFinite()) return false;
    MirrorAim aim = aimOf(model_, picture);
    aim.tip = bur.position;
    aim.shaft = bur.rotation * Vec3::UnitZ();
    return place(mirrorPoseBehind(aim, *touchableSurface(model_)));
}

bool MirrorMouse::placeOverCrown(const Viewport& picture) {
    if (model_.runner() == nullptr || !model_.instruments().meshes()) return false;
    return place(mirrorPoseOverCrown(aimOf(model_, picture), model_.tooth()->box(), *touchableSurface(model_)));
}

bool MirrorMouse::place(const std::optional<Pose>& found) {
    if (found) model_.mirror().place(*found);
    return found.has_value();
}

void MirrorMouse::park() { model_.mirror().reset(); }

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input/mirror_mouse.h"

#include <utility>

#include "session/hands/mirror_aim.h"
#include "session/model/session_model.h"

namespace tactooth {

bool MirrorMouse::hold(bool held) { return std::exchange(held_, held) != held; }

void MirrorMouse::move(const Viewport& picture, const Vec2& from, const Vec2& to, bool tilts) {
    if (tilts) {
        model_.mirror().tilt(picture, to - from);
    } else {
        model_.mirror().drag(picture, from, to);
    }
}

void MirrorMouse::turnWheel(const Viewport& picture, double notches) {
    constexpr double kStep = 1;  // mm
    model_.mirror().approach(picture, kStep * notches);
}

bool MirrorMouse::placeBehindBur(const Viewport& picture) {
    if (model_.runner() == nullptr || !model_.instruments().meshes()) return false;
    const Pose& bur = model_.log().newest().contact.proxy;
    if (!bur.position.allFinite()) return false;
    const MirrorAim aim{.tip = bur.position,
                        .shaft = bur.rotation * Vec3::UnitZ(),
                        .eye = picture.camera().cameraInWorld.position,
                        .handle = -handleX(model_) * Vec3::UnitX(),
                        .radius = model_.instruments().meshes()->disc.radius};
    const std::optional<Pose> place = mirrorPoseBehind(aim, *touchableSurface(model_));
    if (place) model_.mirror().place(*place);
    return place.has_value();
}

void MirrorMouse::park() { model_.mirror().reset(); }

}  // namespace tactooth

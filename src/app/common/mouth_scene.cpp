// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/mouth_scene.h"

namespace tactooth {
namespace {

/// Teeth in place are wet, and a little yellower than the cut face of enamel.
Look toothLook() {
    Look look = looks::enamel();
    look.wetness = std::max(look.wetness, 0.7F);
    return look;
}

}  // namespace

std::vector<ShownBody> shownAround(const ToothInMouth& tooth) {
    std::vector<ShownBody> bodies;
    for (const ToothInMouth::Body& body : tooth.around) {
        bodies.push_back({body.shown, {}, body.isGum ? looks::gingiva() : toothLook(), body.isOpposite});
    }
    return bodies;
}

std::vector<ShownBody> shownMouth(const BuiltinMouth& mouth, ShownJaws jaws) {
    std::vector<ShownBody> bodies;
    const auto add = [&](TriangleMesh mesh, const Pose& pose, const Look& look) {
        bodies.push_back({std::make_shared<const TriangleMesh>(std::move(mesh)), pose, look, false});
    };
    const bool upper = jaws != ShownJaws::lower, lower = jaws != ShownJaws::upper;
    if (upper) add(mouth.upperGingiva, {}, looks::gingiva());
    if (lower) add(mouth.lowerGingiva, mouth.lowerJaw, looks::gingiva());
    for (const MouthTooth& tooth : mouth.teeth) {
        if (tooth.tooth.fdi < 30 ? upper : lower) add(aboveTheGum(tooth.tooth.outer), mouth.poseOf(tooth), toothLook());
    }
    return bodies;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/mouth_scene.h"

namespace tactooth {
namespace {

/// Teeth in the mouth are wet, and slightly yellower than cut enamel.
Appearance toothAppearance() {
    Appearance appearance = appearances::enamel();
    appearance.wetness = std::max(appearance.wetness, 0.7F);
    return appearance;
}

}  // namespace

std::vector<ShownBody> shownAround(std::span<const ToothInMouth::Body> around) {
    std::vector<ShownBody> bodies;
    for (const ToothInMouth::Body& body : around) {
        bodies.push_back(
            {body.shown, {}, body.isGingiva ? appearances::gingiva() : toothAppearance(), body.isOpposite});
    }
    return bodies;
}

std::vector<ShownBody> shownMouth(const BuiltinMouth& mouth, ShownJaws jaws) {
    std::vector<ShownBody> bodies;
    const auto add = [&](TriangleMesh mesh, const Pose& pose, const Appearance& appearance) {
        bodies.push_back({std::make_shared<const TriangleMesh>(std::move(mesh)), pose, appearance, false});
    };
    const bool upper = jaws != ShownJaws::Lower, lower = jaws != ShownJaws::Upper;
    if (upper) add(mouth.upperGingiva, {}, appearances::gingiva());
    if (lower) add(mouth.lowerGingiva, mouth.lowerJaw, appearances::gingiva());
    for (const MouthTooth& tooth : mouth.teeth) {
        if (tooth.tooth.fdi < 30 ? upper : lower)
            add(supragingivalMesh(tooth.tooth.outer), mouth.poseOf(tooth), toothAppearance());
    }
    return bodies;
}

}  // namespace tactooth

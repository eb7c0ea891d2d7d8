// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/frame_block.h"

namespace tactooth {

namespace {

Eigen::Vector4f extended(const Vec3f& vector, float last = 0) { return {vector.x(), vector.y(), vector.z(), last}; }
Eigen::Vector4f extended(const Vec3& vector) { return extended(vector.cast<float>().eval()); }

}  // namespace

double lodToleranceAt(const PassView& view, ImageSize size, double pixels) {
    const double pixelsPerRadian = 0.5 * size.height * view.viewToClip(1, 1);
    return pixels / pixelsPerRadian;
}

FrameBlock frameBlock(const PassView& view, const Lighting& lighting, const Background& background,
                      const ShadowLookup& shadow, ImageSize size, double lodTolerance) {
    const auto width = static_cast<float>(size.width);
    const auto height = static_cast<float>(size.height);
    return {.worldToClip = view.worldToClip().cast<float>(),
            .clipToWorld = view.worldToClip().inverse().cast<float>(),
            .worldToShadow = shadow.worldToShadow.cast<float>(),
            .eye = extended(view.eye),
            .clipPlane = view.clipPlane.cast<float>(),
            .section = view.section.cast<float>(),
            .toKey = extended(lighting.toKey),
            .keyColour = extended(lighting.keyColour),
            .toFill = extended(lighting.toFill),
            .fillColour = extended(lighting.fillColour),
            .skyColour = extended(lighting.skyColour),
            .groundColour = extended(lighting.groundColour),
            .backgroundTop = extended(background.top),
            .backgroundBottom = extended(background.bottom, static_cast<float>(background.kind)),
            .imageSize = {width, height, 1 / width, 1 / height},
            .shadowTexel = {static_cast<float>(shadow.texel), static_cast<float>(shadow.pitch),
                            static_cast<float>(lodTolerance), static_cast<float>(shadow.error)}};
}

}  // namespace tactooth

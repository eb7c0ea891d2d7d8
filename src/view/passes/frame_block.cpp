// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/frame_block.h"

#include <algorithm>
#include <cmath>

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
                            static_cast<float>(lodTolerance), static_cast<float>(shadow.error)},
            .sightEnds = Eigen::Vector4f::Zero(),
            .sightReach = Eigen::Vector4f::Zero()};
}

void addSight(FrameBlock& frame, const SightLine& sight, const PassView& view, ImageSize size) {
    const Mat4 toClip = view.worldToClip();
    const Eigen::Vector4d start = toClip * sight.start.homogeneous(), end = toClip * sight.end.homogeneous();
    constexpr double kNearest = 0.1;  // mm: nearer than any near plane
    const double depth = std::min(start.w(), end.w());
    if (depth < kNearest) return;
    const auto pixel = [&](const Eigen::Vector4d& point) -> Vec2 {
        return 0.5 * Vec2((point.x() / point.w() + 1) * size.width, (point.y() / point.w() + 1) * size.height);
    };
    const double perMm = 0.5 * size.height * view.viewToClip(1, 1) / depth;
    // A line across the view hides nothing behind its end: there the window ends with the line. A line along the view
    // ends in a round window.
    const Vec3 along = sight.end - sight.start;
    const Vec3 toEye = view.eye - sight.start;
    const double lengths = along.norm() * toEye.norm();
    const double endOn = lengths > 0 ? std::pow(along.dot(toEye) / lengths, 4) : 1;
    constexpr double kClearance = 0.1;  // mm
    const Vec2 first = pixel(start), last = pixel(end);
    frame.sightEnds = Eigen::Vector4d(first.x(), first.y(), last.x(), last.y()).cast<float>();
    frame.sightReach =
        Eigen::Vector4d(depth, perMm * sight.radius, perMm * (endOn * sight.radius + kClearance), perMm).cast<float>();
}

}  // namespace tactooth

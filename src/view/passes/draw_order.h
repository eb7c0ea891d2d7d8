// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "view/camera/camera.h"

namespace tactooth {

/// A box that encloses a body, and the pose of that body.
struct PlacedBox {
    Box3 box;  ///< object frame, mm
    Mat4 objectToWorld = Mat4::Identity();
};

/// The numbers of the bodies in the order in which to draw them: by the distance of their farthest point from `eye`
/// (world frame, mm), nearest first; equal ones keep their order. What is drawn first hides what comes later, whose
/// pixels then need no lighting: small bodies near the eye, as burs and teeth, come before the gum and the mouth around
/// them.
[[nodiscard]] std::vector<std::size_t> nearestFirst(std::span<const PlacedBox> bodies, const Vec3& eye);

}  // namespace tactooth

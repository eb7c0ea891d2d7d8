// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/util/pose.h"
#include "geometry/util/ray.h"

namespace tactooth {

using Mat4 = Eigen::Matrix4d;

/// Size of a picture in pixels.
struct ImageSize {
    int width = 0;
    int height = 0;

    [[nodiscard]] double aspect() const { return static_cast<double>(width) / height; }
    bool operator==(const ImageSize&) const = default;
};

/// An infinite plane: the points x with normal . x = offset; `normal` is a unit vector.
struct Plane {
    Vec3 normal = Vec3::UnitZ();
    double offset = 0;

    [[nodiscard]] double signedDistance(const Vec3& point) const { return normal.dot(point) - offset; }
};

/// A perspective camera. Its viewing direction is its own -z; in the picture +x is to the right and +y is up.
struct Camera {
    Pose cameraInWorld;
    double fieldOfView = 0.44;  ///< full vertical angle, rad; 25 degrees is the field of view of a dentist with loupes
    double nearDistance = 1.0;  ///< mm; nothing nearer is drawn
    double farDistance = 1000.0;  ///< mm; nothing farther is drawn
    /// Off-axis shift of the picture's centre, in half picture heights, for one eye of a stereo pair.
    double lensShift = 0;
};

/// World coordinates to camera coordinates.
[[nodiscard]] Mat4 viewMatrix(const Camera& camera);

/// Camera coordinates to OpenGL clip coordinates, for a picture with aspect = width / height.
[[nodiscard]] Mat4 projectionMatrix(const Camera& camera, double aspect);

/// The reflection in `plane`, as a matrix on points (world).
[[nodiscard]] Mat4 reflectionMatrix(const Plane& plane);

/// The line of sight through `pixel` (origin at the picture's top left corner, y down, the first pixel's centre is at
/// 0.5, 0.5). It begins at the near plane: nothing nearer is drawn, so nobody points at it.
[[nodiscard]] Ray rayThrough(const Camera& camera, ImageSize size, const Vec2& pixel);

/// The position of `point` (world) in the picture; nothing if it is not in front of the eye.
[[nodiscard]] std::optional<Vec2> project(const Camera& camera, ImageSize size, const Vec3& point);

}  // namespace tactooth

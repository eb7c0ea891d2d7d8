// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/surface_buffers.h"

namespace tactooth {

/// A scene object that is to be drawn, with its buffers.
struct Drawable {
    const SceneObject* object = nullptr;
    SurfaceBuffers* buffers = nullptr;
    Mat4 objectToWorld = Mat4::Identity();
    Box3 changed = {};  ///< object frame: where the shape is another than in the picture before; empty = nowhere

    /// Whether light passes: it is blended over all that is opaque.
    [[nodiscard]] bool isTransparent() const;
    /// Whether faces that look away from the eye cannot be seen.
    [[nodiscard]] bool cullsBackFaces(bool inSection) const;
};

/// `pose` as a matrix on points.
[[nodiscard]] Mat4 matrixOf(const Pose& pose);

/// Where the object stands, its spin included.
[[nodiscard]] Mat4 objectToWorld(const SceneObject& object);

/// The axis-parallel box around `drawable`, in the frame that `worldToFrame` leads to.
[[nodiscard]] Box3 boxOf(const Drawable& drawable, const Mat4& worldToFrame);
/// Likewise around `box`, which `toFrame` leads there; empty if `box` is.
[[nodiscard]] Box3 transformedBox(const Box3& box, const Mat4& toFrame);

}  // namespace tactooth

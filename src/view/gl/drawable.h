// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/gl/surface_buffers.h"

namespace tactooth {

/// A scene object to draw, with its buffers.
struct Drawable {
    const SceneObject* object = nullptr;
    SurfaceBuffers* buffers = nullptr;
    Mat4 objectToWorld = Mat4::Identity();
    Box3 changed = {};  ///< object frame: where the shape differs from the frame before; empty: nowhere

    /// Whether it is transparent: it is blended over everything opaque.
    [[nodiscard]] bool isTransparent() const;
    /// Whether faces that point away from the eye are invisible.
    [[nodiscard]] bool cullsBackFaces(bool inSection) const;
};

/// `pose` as a matrix on points.
[[nodiscard]] Mat4 matrixOf(const Pose& pose);

/// The object's pose as a matrix, including its spin.
[[nodiscard]] Mat4 objectToWorld(const SceneObject& object);

/// The axis-aligned box of `drawable` in the target frame of `worldToFrame`.
[[nodiscard]] Box3 boxOf(const Drawable& drawable, const Mat4& worldToFrame);
/// The axis-aligned box of the `box` that `toFrame` transforms; empty if `box` is empty.
[[nodiscard]] Box3 transformedBox(const Box3& box, const Mat4& toFrame);

}  // namespace tactooth

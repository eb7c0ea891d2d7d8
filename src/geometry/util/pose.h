// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// A rigid transform: where a body's frame stands in another frame. `bodyInWorld * pointOfBody = pointInWorld`.
/// The name of a variable says both frames (`toolInTooth`).
struct Pose {
    Vec3 position = Vec3::Zero();      ///< mm
    Quat rotation = Quat::Identity();  ///< unit

    [[nodiscard]] Vec3 operator*(const Vec3& point) const { return rotation * point + position; }
    [[nodiscard]] Pose operator*(const Pose& inner) const {
        return {rotation * inner.position + position, (rotation * inner.rotation).normalized()};
    }
    [[nodiscard]] Pose inverse() const {
        const Quat back = rotation.conjugate();
        return {back * -position, back};
    }
};

/// The shortest turn that brings one direction onto another; neither is zero, nor need they be unit. Opposite ones have
/// many: then about some axis across them. In a file of its own, since Eigen solves that case by a decomposition that
/// takes the compiler ten seconds wherever it is used.
[[nodiscard]] Quat shortestRotation(const Vec3& from, const Vec3& to);

}  // namespace tactooth

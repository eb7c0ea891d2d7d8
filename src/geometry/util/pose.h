// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/util/vec.h"

namespace tactooth {

/// A rigid transform: where a body's frame stands in another frame. `bodyInWorld * pointOfBody = pointInWorld`. The
/// name of a variable says both frames (`toolInTooth`).
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

/// Squared length may differ from 1 by this much; a quaternion from a device is accepted with the same error.
inline constexpr double kUnitLengthTolerance = 1e-3;

/// Whether the length of a direction or of a quaternion is 1. False for NaN.
template <class Vector>
[[nodiscard]] bool isUnit(const Eigen::MatrixBase<Vector>& direction) {
    return std::abs(static_cast<double>(direction.squaredNorm()) - 1) < kUnitLengthTolerance;
}
[[nodiscard]] inline bool isUnit(const Quat& rotation) {
    return std::abs(rotation.squaredNorm() - 1) < kUnitLengthTolerance;
}

/// Whether a pose is a rigid transform: a finite position and a unit quaternion.
[[nodiscard]] inline bool isRigid(const Pose& pose) { return pose.position.allFinite() && isUnit(pose.rotation); }

/// The shortest rotation that brings one direction onto another. The directions must not be zero, but they need not be
/// unit vectors. For opposite directions it is a rotation by pi about some perpendicular axis. It has a file of its own
/// because Eigen solves that case by a decomposition that takes the compiler ten seconds in each file that uses it.
[[nodiscard]] Quat shortestRotation(const Vec3& from, const Vec3& to);

}  // namespace tactooth

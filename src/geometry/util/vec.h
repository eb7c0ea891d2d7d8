// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tactooth {

using Vec2 = Eigen::Vector2d;   ///< in a plane or a picture
using Vec3 = Eigen::Vector3d;   ///< mm (points, steps), unit-less (directions), N (forces)
using Vec3f = Eigen::Vector3f;  ///< the same, as an STL file stores it
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;
using Box3 = Eigen::AlignedBox3d;

/// Largest coordinate of a surface or of a pose, mm: a thousand jaws. Beyond it single precision is coarser than a
/// tenth of a millimetre, and finding a contact takes seconds.
inline constexpr double kMaxCoordinate = 1e6;

}  // namespace tactooth

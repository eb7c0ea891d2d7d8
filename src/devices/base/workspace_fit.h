// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/base/haptic_device.h"

namespace tactooth {

inline constexpr double kMinMotionScaling = 1, kMaxMotionScaling = 3;  ///< mm of the device for each mm of the tool

/// Result of fitting a workspace: the motion scaling and whether it covers the whole box.
struct WorkspaceFit {
    double motionScaling = kMinMotionScaling;
    bool coversBox = true;  ///< without use of the clutch
};

/// The largest motion scaling at which a device with a workspace of size `workspace` brings the tool to all points of a
/// box of size `box`. Both sizes are in mm along the device's axes, and the centres coincide. The result is a multiple
/// of 0.1, like the value that the user can set. If even the smallest motion scaling does not cover the box, the result
/// is the smallest.
[[nodiscard]] WorkspaceFit fitWorkspace(const Vec3& workspace, const Vec3& box);

/// Size along the device's axes of a box that is aligned with the tooth's axes. `turn`: rotation from the device's
/// frame into the tooth's.
[[nodiscard]] Vec3 sizeInDeviceFrame(const Vec3& size, const Quat& turn);

/// Whether the device position is within `margin` mm of the workspace limit, or outside the workspace. False if the
/// position of the workspace is unknown.
[[nodiscard]] bool isNearWorkspaceLimit(const DeviceInfo& device, const Vec3& hand, double margin);

}  // namespace tactooth

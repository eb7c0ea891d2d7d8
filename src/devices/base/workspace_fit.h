// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/base/haptic_device.h"

namespace tactooth {

inline constexpr double kMinMotionScaling = 1, kMaxMotionScaling = 3;  ///< mm of the hand for each mm of the tool

/// How finely a hand can work.
struct WorkspaceFit {
    double motionScaling = kMinMotionScaling;
    bool coversBox = true;  ///< from one place of the clutch
};

/// The greatest fineness at which a hand in a room of this size brings the tool to all of a box of that size, both in
/// mm along the hand's axes and with their middles on each other. In tenths, as it can be set by hand. Where even the
/// least fineness does not reach all, that one.
[[nodiscard]] WorkspaceFit fitWorkspace(const Vec3& room, const Vec3& box);

/// The size along the hand's axes of a box that lies along the tooth's. `turn`: from the hand's frame into the tooth's.
[[nodiscard]] Vec3 sizeInDeviceFrame(const Vec3& size, const Quat& turn);

/// Whether a hand is no more than `margin` mm inside the room of its device, or outside; false where it is not known
/// where that room is.
[[nodiscard]] bool isNearWorkspaceLimit(const DeviceInfo& device, const Vec3& hand, double margin);

}  // namespace tactooth

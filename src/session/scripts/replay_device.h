// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// Opens a device as openDevice does, or "replay:FILE": a device that follows a trajectory (see readTrajectory) in the
/// tooth frame at any force, and rests at its end. Fails with one sentence that says what to do.
[[nodiscard]] Expected<std::unique_ptr<HapticDevice>> openDeviceOrReplay(const std::string& name,
                                                                         bool leftHanded = false, double rateHz = 1000);

}  // namespace tactooth

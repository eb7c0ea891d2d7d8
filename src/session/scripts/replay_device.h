// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// What openDevice opens, and "replay:FILE": a hand that goes the way of a trajectory (see readTrajectory) in the
/// tooth's frame, whatever force it meets, and rests at its end. Fails with one sentence that says what to do.
[[nodiscard]] Expected<std::unique_ptr<HapticDevice>> openDeviceOrReplay(const std::string& name,
                                                                         bool leftHanded = false, double rateHz = 1000);

}  // namespace tactooth

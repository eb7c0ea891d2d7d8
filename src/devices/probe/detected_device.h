// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "geometry/util/vec.h"

namespace tactooth {

enum class DeviceState {
    Ready,
    NotFound,  ///< no device is plugged in, or its driver is not installed or not running
    Unusable,  ///< a device is present but cannot be used: broken, in use, of another version
};

/// Capabilities of a device, as far as they are known.
struct DeviceCapabilities {
    std::optional<double> force;            ///< N; 0: renders no force
    std::optional<double> continuousForce;  ///< N that its motors bear without time limit
    std::optional<Vec3> workspace;          ///< mm
    std::optional<double> stiffness;        ///< N/mm: the stiffest wall that is stable
    std::optional<int> buttons;
};

/// A device that was found, or the reason why none was.
struct DetectedDevice {
    std::string name;     ///< value for --device; "pedal": a foot pedal
    std::string backend;  ///< display name
    DeviceState state = DeviceState::NotFound;
    std::string text;  ///< capabilities; if not ready, one sentence with the reason and the remedy
    DeviceCapabilities capabilities = {};
};

}  // namespace tactooth

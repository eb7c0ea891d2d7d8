// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "geometry/util/vec.h"

namespace tactooth {

enum class DeviceState {
    Ready,
    NotFound,  ///< nothing is plugged in, or its driver is not installed or does not run
    Unusable,  ///< something is there that cannot be used: broken, in use, of another version
};

/// What a device can do, as far as it is known.
struct DeviceCapabilities {
    std::optional<double> force;            ///< N; 0: renders none
    std::optional<double> continuousForce;  ///< N that its motors bear for ever
    std::optional<Vec3> workspace;          ///< mm
    std::optional<double> stiffness;        ///< N/mm: the stiffest wall that does not shake
    std::optional<int> buttons;
};

/// A device that is there, or the reason why one is not.
struct DetectedDevice {
    std::string name;     ///< as --device takes it; "pedal": a foot pedal
    std::string backend;  ///< for people
    DeviceState state = DeviceState::NotFound;
    std::string text;  ///< what it can do; if not ready, one sentence that says why and what to do
    DeviceCapabilities capabilities = {};
};

}  // namespace tactooth

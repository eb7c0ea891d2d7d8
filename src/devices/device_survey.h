// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tactooth {

/// A device that is there, or the reason why one is not.
struct SurveyedDevice {
    std::string name;     ///< as --device takes it; "pedal": a foot pedal
    std::string backend;  ///< for people
    bool ready = false;
    std::string text;  ///< what it can do; if not ready, one sentence that says why and what to do
};

/// Looks for all devices. Vendors' libraries are tried in child processes.
[[nodiscard]] std::vector<SurveyedDevice> surveyDevices();

}  // namespace tactooth

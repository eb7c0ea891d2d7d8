// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "session/recording/recording_seal.h"

namespace tactooth {

/// What the seal of a recording proves, as one line for people.
[[nodiscard]] std::string sealText(const SealReport& report);
/// The same for programs.
[[nodiscard]] nlohmann::ordered_json sealJson(const SealReport& report);

}  // namespace tactooth

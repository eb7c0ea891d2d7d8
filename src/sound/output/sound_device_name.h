// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth {

/// OpenAL's name of the default device; empty if there is none. Takes as long as opening it.
[[nodiscard]] std::string defaultSoundDevice();

/// Whether this is OpenAL's null driver: it accepts sound like a card, and nothing is heard.
[[nodiscard]] bool isNullSoundDevice(const std::string& name);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth {

/// The device that OpenAL opens unless it is told which, by OpenAL's name for it; empty if there is none. Takes as long
/// as opening it.
[[nodiscard]] std::string defaultSoundDevice();

/// Whether this is OpenAL's null driver: it takes the sound as a card would, and nothing is heard.
[[nodiscard]] bool isNullSoundDevice(const std::string& name);

}  // namespace tactooth

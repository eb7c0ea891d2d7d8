// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>
#include <string_view>

namespace tactooth {

/// Why something did not work (Error::message, or the trouble of a device) in the language of the window; the sentence
/// itself where the window has no words for it.
[[nodiscard]] QString translatedError(std::string_view message);

/// What there are words for, with %1, %2 ... for the names, the numbers and the sentences within.
[[nodiscard]] std::span<const char* const> translatableErrors();

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace tactooth {

// What the layers below the window may report, by topic. %1, %2 ...: a name, a number or a sentence of its own, in the
// order of the English sentence.

/// Files, surfaces, teeth and cases.
[[nodiscard]] std::span<const char* const> fileErrors();
/// What is wrong in a text that a person writes: TOML and CSV.
[[nodiscard]] std::span<const char* const> textErrors();
/// Devices, sound and display.
[[nodiscard]] std::span<const char* const> deviceErrors();

}  // namespace tactooth

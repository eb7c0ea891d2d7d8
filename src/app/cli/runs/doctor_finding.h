// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tactooth {

enum class FindingState {
    Fine,
    Optional,  ///< the program works without it
    Missing,   ///< the window does not open, or does not stay open
};

/// The doctor's report on one part of the computer.
struct Finding {
    const char* area;
    FindingState state;
    std::string text;  ///< sentences; if the part is not fine, they give the remedy
};

/// Time that a graphics or sound driver has to answer, s.
inline constexpr double kDriverTimeout = 20;

/// Returns `text` with a capital letter at its start and a full stop at its end.
[[nodiscard]] std::string asSentence(std::string text);

}  // namespace tactooth

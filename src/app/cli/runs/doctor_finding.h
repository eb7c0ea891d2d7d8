// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tactooth {

enum class Verdict {
    Fine,
    Optional,  ///< works without
    Missing,   ///< the window does not open, or does not stay open
};

/// What the doctor says about one part of the computer.
struct Finding {
    const char* area;
    Verdict verdict;
    std::string text;  ///< sentences; if it is not fine, they say what to do
};

/// s for a graphics or sound driver to answer.
inline constexpr double kDriverTimeout = 20;

/// `text` with a capital letter and a full stop.
[[nodiscard]] std::string asSentence(std::string text);

}  // namespace tactooth

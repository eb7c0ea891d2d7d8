// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace tactooth {

/// For CLI::Option::transform: the one check of every number on the command line. What is no number as a whole (with
/// '.' as decimal point, whatever the locale), not finite or out of range is refused with "must be a number from 0.005
/// to 0.5, but is nan"; what is in range is handed on as the library reads it.
[[nodiscard]] CLI::Validator numberFrom(double low, double high);

/// The same for a whole number, in decimal digits alone: no "1e3", no "0x10", no "10.0".
[[nodiscard]] CLI::Validator wholeNumberFrom(std::int64_t low, std::int64_t high);

/// The seed of a patient.
[[nodiscard]] inline CLI::Validator seedNumber() { return wholeNumberFrom(0, UINT32_MAX); }

/// The FDI number of a permanent tooth, roughly: 11 to 48.
[[nodiscard]] inline CLI::Validator fdiNumber() { return wholeNumberFrom(11, 48); }

}  // namespace tactooth

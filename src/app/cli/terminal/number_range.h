// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace tactooth {

/// For CLI::Option::transform: the only check of every number on the command line. It rejects text that is not entirely
/// a number (with '.' as decimal point, whatever the locale), not finite or out of range. The message is "must be a
/// number from 0.005 to 0.5, but is nan". A number in range is passed on in the form that the library reads.
[[nodiscard]] CLI::Validator numberFrom(double low, double high);

/// The same for a whole number, in decimal digits only: no "1e3", no "0x10", no "10.0".
[[nodiscard]] CLI::Validator wholeNumberFrom(std::int64_t low, std::int64_t high);

/// The seed of a patient.
[[nodiscard]] inline CLI::Validator seedNumber() { return wholeNumberFrom(0, UINT32_MAX); }

/// Approximate check of the FDI number of a permanent tooth: 11 to 48.
[[nodiscard]] inline CLI::Validator fdiNumber() { return wholeNumberFrom(11, 48); }

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace tactooth {

/// The sentence for a command whose memory does not suffice: names the largest surface among its arguments where that
/// is larger than any mouth, since then its unit is not what was thought.
[[nodiscard]] std::string tooLargeMessage(std::span<const char* const> arguments);

}  // namespace tactooth

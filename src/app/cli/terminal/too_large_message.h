// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/util/expected.h"

namespace tactooth {

/// The sentence for a command whose memory does not suffice: names the largest surface among its arguments where that
/// is larger than any mouth, since then its unit is not what was thought.
[[nodiscard]] Error tooLargeMessage(std::span<const char* const> arguments);

}  // namespace tactooth

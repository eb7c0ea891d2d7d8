// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/util/expected.h"

namespace tactooth {

/// The error message of a command that runs out of memory. If the largest surface among its arguments is larger than
/// any mouth, the message names it, because its unit is then not the assumed one.
[[nodiscard]] Error tooLargeMessage(std::span<const char* const> arguments);

}  // namespace tactooth

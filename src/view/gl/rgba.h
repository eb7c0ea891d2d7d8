// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace tactooth {

/// Red, green, blue (sRGB), opacity; 0..255 each.
using Rgba = std::array<std::uint8_t, 4>;

}  // namespace tactooth

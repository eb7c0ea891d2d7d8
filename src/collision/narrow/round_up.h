// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Times a length: more than single precision may lose.
inline constexpr float kRoundUp = 1.00001F;

}  // namespace tactooth

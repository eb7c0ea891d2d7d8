// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace tactooth {

/// A degree, rad.
inline constexpr double kDegree = std::numbers::pi / 180;

}  // namespace tactooth

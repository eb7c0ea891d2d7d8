// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth::test {

/// A tick of the servo loop, s.
inline constexpr double kTick = 1e-3;

}  // namespace tactooth::test

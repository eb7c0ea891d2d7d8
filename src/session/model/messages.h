// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this folder: what it says to people, in both languages.
namespace tactooth::msg {

inline constexpr MessageText kStepStroke{"step_stroke", "Cut", "切削"};
inline constexpr MessageText kStepReset{"step_reset", "Whole tooth again", "歯を元に戻す"};
inline constexpr MessageText kStepBur{"step_bur", "Bur: %1", "バー：%1"};
inline constexpr MessageText kStepInstrument{"step_instrument", "Instrument: %1", "器具：%1"};

}  // namespace tactooth::msg

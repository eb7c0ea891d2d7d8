// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Sample rate of everything in this layer, Hz: the rate of common sound cards, with room for a rotation of 400 000
/// rev/min (6.7 kHz) and two harmonics below half the rate.
inline constexpr int kSoundRate = 48000;

/// Samples in a block, 2.5 ms.
inline constexpr int kSoundBlock = 120;

/// Samples that the sound device takes at a time, 5 ms: shorter than the 30 ms up to which hand and ear notice the same
/// cut, and longer than most late wake-ups of a thread.
inline constexpr int kDevicePeriod = 2 * kSoundBlock;

}  // namespace tactooth

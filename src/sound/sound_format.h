// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Samples a second of everything in this layer: the rate of common sound cards, with room for a rotation of
/// 400 000 rev/min (6.7 kHz) and two harmonics below half the rate.
inline constexpr int kSoundRate = 48000;

/// Samples that are made and handed over together, 5 ms: short enough for a delay that nobody notices, long enough
/// that one missed wake-up of the thread is covered by the queue.
inline constexpr int kSoundBlock = 240;

}  // namespace tactooth

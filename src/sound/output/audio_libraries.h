// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Sets OpenAL and ALSA up for this process. Call it at the start of a program, before it has threads and before any
/// sound; without it everything works, but later and noisier. What the user has set by himself is respected.
/// - Two short mixing periods (5 ms): OpenAL Soft's three of 21 ms are late for a hand that feels the cut.
/// - No page of errors on the error stream where there is no sound card, since going on silently is all that there is
///   to do.
void prepareAudioLibraries();

/// ALSA's part of the silence: safe at any time. Does nothing where there is no ALSA.
void silenceAlsaMessages();

}  // namespace tactooth

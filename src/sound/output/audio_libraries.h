// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Configures OpenAL and ALSA for this process. Call it at the start of a program, before other threads and any sound.
/// Without it everything works, but with more latency and with messages. Settings of the user have priority.
/// - Two short mixing periods (5 ms): the three periods of 21 ms of OpenAL Soft are too late for a hand that feels the
///   cut.
/// - No error messages on the error stream where there is no sound card, since the program goes on silently.
void prepareAudioLibraries();

/// Suppresses the messages of ALSA; safe at any time. Does nothing where there is no ALSA.
void silenceAlsaMessages();

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// On a machine without a sound card ALSA and OpenAL each write a page of errors to the error stream, although going on
/// silently is all that there is to do. Call this at the start of a program, before it has threads; the user's own
/// ALSOFT_LOGLEVEL is respected.
void quietAudioLibraries();

/// ALSA's part of it: safe at any time. Does nothing where there is no ALSA.
void silenceAlsaMessages();

}  // namespace tactooth

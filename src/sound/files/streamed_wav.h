// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tactooth {

/// Gives a WAV file (RIFF or RF64) that was written through a pipe its lengths, in memory. Its writer could neither
/// know them at the beginning nor go back: it wrote FFFFFFFF, 7FFFF000, another number from there on, or 0. The samples
/// then go on to the end of the file, which becomes a plain RIFF file that says so. A length that somebody meant stays:
/// what is shorter than that was cut off.
void completeStreamedWav(std::vector<std::byte>& wav);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace tactooth {

/// Writes the missing lengths into a WAV file (RIFF or RF64) in memory that was written through a pipe. Its writer did
/// not know them at the beginning and could not seek: it wrote FFFFFFFF, 7FFFF000, another number from there on, or 0.
/// The samples then extend to the end of the file, which becomes a plain RIFF file with correct lengths. A plausible
/// length stays: a file shorter than that was cut off.
void completeStreamedWav(std::vector<std::byte>& wav);

}  // namespace tactooth

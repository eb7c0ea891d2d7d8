// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sndfile.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace tactooth {

/// A sound file in memory that libsndfile reads and writes. libsndfile seeks in it, which AtomicFile cannot do, and a
/// file that was read as a whole cannot change while it is parsed.
struct MemoryFile {
    std::vector<std::byte> bytes;
    std::size_t place = 0;
};

struct CloseSoundFile {
    void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseSoundFile>;

/// `mode` and `info` are those of sf_open; null if libsndfile refuses. `file` must live longer than the result.
[[nodiscard]] SoundFile openInMemory(MemoryFile& file, int mode, SF_INFO& info);

}  // namespace tactooth

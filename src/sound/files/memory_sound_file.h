// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sndfile.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace tactooth {

/// A file in memory that libsndfile reads and writes: it goes to and fro in it, which AtomicFile cannot, and a file
/// that was read whole cannot change while it is being understood.
struct MemoryFile {
    std::vector<std::byte> bytes;
    std::size_t place = 0;
};

struct CloseSoundFile {
    void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseSoundFile>;

/// `mode` and `info` as for sf_open; null if libsndfile refuses. `file` outlives the result.
[[nodiscard]] SoundFile openInMemory(MemoryFile& file, int mode, SF_INFO& info);

}  // namespace tactooth

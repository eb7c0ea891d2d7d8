// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#ifndef _WIN32
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#endif

namespace tactooth::test {

/// Memory that a test shares with the stand-in library in another process: what its hand does, and when the pen had a
/// force. The variable TACTOOTH_STANDIN_RECORD names the file. Times are s of the monotonic clock.
struct PenRecord {
    std::array<std::atomic<double>, 3> wanted{};  ///< target position of the hand, mm, in HDAPI's frame
    std::atomic<double> force{0};                 ///< N, of the first pen
    std::atomic<double> zeroAt{0};                ///< when the force became zero; 0 while there is one
    std::atomic<std::int64_t> ticks{0};
    std::atomic<std::int32_t> process{0};  ///< number of the process that holds the pen
    std::int32_t unused = 0;
};
static_assert(std::atomic<double>::is_always_lock_free);

#ifndef _WIN32
/// Maps a file of that size; nullptr without one.
inline PenRecord* mapPenRecord(const char* path) {
    const int file = path != nullptr ? open(path, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0) return nullptr;
    void* const place = mmap(nullptr, sizeof(PenRecord), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return place == MAP_FAILED ? nullptr : std::launder(static_cast<PenRecord*>(place));
}
#endif

}  // namespace tactooth::test

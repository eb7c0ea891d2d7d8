// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <semaphore.h>

#include "devices/base/monotonic_clock.h"

namespace tactooth {

/// Until someone posts, or for `longest` s. Whoever sets the computer's clock changes nothing; on Windows, whose
/// threads know no other, that wait alone.
inline void waitForSemaphore(sem_t& semaphore, double longest) {
#ifdef _WIN32
    const auto wait =
        std::chrono::duration_cast<std::chrono::system_clock::duration>(std::chrono::duration<double>(longest));
    const timespec end = timespecOf(std::chrono::system_clock::now() + wait);
    (void)sem_timedwait(&semaphore, &end);
#else
    const timespec end = timespecOf(secondsFromNow(longest));
    (void)sem_clockwait(&semaphore, CLOCK_MONOTONIC, &end);
#endif
}

}  // namespace tactooth

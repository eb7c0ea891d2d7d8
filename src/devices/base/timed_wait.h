// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <semaphore.h>

#include "devices/base/monotonic_clock.h"

namespace tactooth {

/// Waits until the semaphore is posted, at most `longest` s. A change of the computer's clock has no effect, except on
/// Windows: its threads can wait only by the system clock, so a change affects the wait in progress there.
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

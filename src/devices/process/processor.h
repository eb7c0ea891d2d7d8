// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sched.h>

namespace tactooth {

/// Keeps the calling thread on one processor, counted from 0. False where the system refuses.
inline bool keepOnProcessor(int processor) {
    if (processor < 0 || processor >= CPU_SETSIZE) return false;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(processor, &only);
    return sched_setaffinity(0, sizeof only, &only) == 0;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth {

/// Gives the calling thread a fixed real-time priority above all ordinary threads. False where the system forbids it.
[[nodiscard]] bool acquireRealTimePriority();

/// Locks the program's memory, present and future, so that it is not swapped out. False where the system forbids it. A
/// small allowance counts as forbidden, since threads would then fail to start.
bool lockMemory();
/// Whether the memory is locked.
[[nodiscard]] bool isMemoryLocked();

/// What the system allows this user; nothing is changed.
struct RealTimeRights {
    bool priority = false;
    bool memory = false;
    bool cpuLatency = false;  ///< CpuLatencyRequest
};
[[nodiscard]] RealTimeRights realTimeRights();

/// The missing rights: "real-time priority, locked memory"; empty if none is missing.
[[nodiscard]] std::string missingRights(const RealTimeRights& rights);

/// One or two sentences on how to get the missing rights; empty if none is missing.
[[nodiscard]] std::string realTimeHint(const RealTimeRights& rights);

}  // namespace tactooth

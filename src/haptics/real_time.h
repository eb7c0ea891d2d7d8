// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tactooth {

/// Gives the calling thread a fixed real-time priority above everything ordinary. False where the system forbids it.
[[nodiscard]] bool acquireRealTimePriority();

/// Keeps the program's memory from being moved out to disk, also what it takes later. False where the system forbids
/// it; a small allowance counts as forbidden, since threads would then fail to start.
bool lockMemory();
/// Whether that has been done.
[[nodiscard]] bool isMemoryLocked();

/// What the system allows this user, without taking it.
struct RealTimeRights {
    bool priority = false;
    bool memory = false;
    bool cpuLatency = false;  ///< CpuLatencyRequest
};
[[nodiscard]] RealTimeRights realTimeRights();

/// What is missing: "real-time priority, locked memory"; empty if nothing is.
[[nodiscard]] std::string missingRights(const RealTimeRights& rights);

/// A sentence or two that say how to get the rights that are missing; empty if none is.
[[nodiscard]] std::string realTimeHint(const RealTimeRights& rights);

}  // namespace tactooth

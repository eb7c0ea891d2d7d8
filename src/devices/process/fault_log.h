// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "devices/process/hand_fault.h"

// The fault log: why the force of a device was cut, one line for each time. A CSV file with the columns time (UTC),
// cause (nameOf), device, force_n (at that moment) and zero_ms (from the moment at which the fault could be known until
// the force was zero).

namespace tactooth {

/// One line of the fault log.
struct FaultRecord {
    std::chrono::system_clock::time_point time;
    HandFault cause = HandFault::None;
    std::string device;  ///< its name
    double force = 0;    ///< N
    double toZero = 0;   ///< s; not known where the hand process itself is gone: 0
};

inline constexpr std::size_t kMaxFaultLogBytes = 64 * 1024;  ///< about a thousand lines; the oldest half is dropped

/// $XDG_STATE_HOME/tactooth/hand-faults.csv, else ~/.local/state/tactooth/hand-faults.csv, else empty.
[[nodiscard]] std::filesystem::path faultLogFile();

/// Adds a line. Several processes may do so at the same time. Makes the folder if it is missing. False where the file
/// cannot be written; an empty path is no file.
bool appendFault(const std::filesystem::path& file, const FaultRecord& record);

/// The newest records, at most `most`, oldest first. Lines that are none are left out; there are none without a file.
[[nodiscard]] std::vector<FaultRecord> readFaults(const std::filesystem::path& file, std::size_t most);

/// "2026-11-27 07:08:22 UTC"
[[nodiscard]] std::string faultTimeText(std::chrono::system_clock::time_point time);

}  // namespace tactooth

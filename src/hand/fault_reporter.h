// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "devices/process/fault_log.h"
#include "devices/process/force_watchdog.h"

namespace tactooth {

/// What the system says of the program.
enum class ProgramState { Runs, Stopped, Gone };

/// The state of the process of that number, from /proc.
[[nodiscard]] ProgramState stateOfProcess(int process);

/// Writes the cuts of the watchdog to the fault log. The watchdog knows that no force has come; a moment later the
/// system knows why, and one line says it.
class FaultReporter {
public:
    FaultReporter(std::filesystem::path file, std::string device)
        : file_(std::move(file)), device_(std::move(device)) {}

    void add(const ForceCut& cut);
    /// Writes what has waited long enough. `now`: s of the monotonic clock.
    void step(double now, ProgramState program);
    /// Writes all that is left.
    void finish(ProgramState program);

private:
    void write(const ForceCut& cut) const;

    std::filesystem::path file_;
    std::string device_;
    std::optional<ForceCut> waiting_;  // without a force
};

}  // namespace tactooth

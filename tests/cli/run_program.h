// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/test_data.h"

namespace tactooth::test {

/// The results of a run of the program.
struct ProgramRun {
    int exitCode = -1;  ///< -1: ended by a signal
    int signal = 0;     ///< the signal that ended it
    std::string out;
    std::string err;
};

/// Variables that differ from those of this process; nullopt: not set.
using Environment = std::map<std::string, std::optional<std::string>>;

/// The real program while it runs, with `arguments` and without a shell.
class RunningTactooth {
public:
    explicit RunningTactooth(const std::vector<std::string>& arguments, const Environment& changes = {});

    [[nodiscard]] pid_t number() const { return process_; }
    /// Waits for its end; call it once.
    [[nodiscard]] ProgramRun wait();

private:
    TemporaryFolder folder_;
    pid_t process_ = 0;
};

/// Runs the real program with `arguments` (without a shell) and waits for its end.
[[nodiscard]] ProgramRun runTactooth(const std::vector<std::string>& arguments, const Environment& changes = {});

}  // namespace tactooth::test

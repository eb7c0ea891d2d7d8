// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

/// Parses the program's arguments and runs the command that they name. Returns the program's exit code, one of
/// ExitCode.
[[nodiscard]] int runCommandLine(int argc, const char* const* argv);

}  // namespace tactooth

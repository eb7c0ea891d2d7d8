// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

struct DoctorOptions {
    bool json = false;
};

/// Checks everything that the program needs from this computer. Prints what to do about each missing part. Returns an
/// ExitCode: negative if the window cannot open.
[[nodiscard]] int runDoctor(const DoctorOptions& options);

}  // namespace tactooth

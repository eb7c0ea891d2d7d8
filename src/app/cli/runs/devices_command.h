// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

struct DevicesOptions {
    bool json = false;
};

/// Lists the connected devices and the abilities of each. Returns an ExitCode.
[[nodiscard]] int runDevices(const DevicesOptions& options);

}  // namespace tactooth

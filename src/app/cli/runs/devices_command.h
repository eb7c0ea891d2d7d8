// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

struct DevicesOptions {
    bool json = false;
};

/// Lists the devices that are there and what each can do: an ExitCode.
[[nodiscard]] int runDevices(const DevicesOptions& options);

}  // namespace tactooth

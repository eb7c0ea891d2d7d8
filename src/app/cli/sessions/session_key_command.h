// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tactooth {

struct SessionKeyOptions {
    bool json = false;
};
/// Prints the public key of this station, and makes the key pair if there is none yet. The secret half is never shown.
[[nodiscard]] int runSessionKey(const SessionKeyOptions& options);

}  // namespace tactooth

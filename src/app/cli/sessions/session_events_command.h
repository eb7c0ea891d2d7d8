// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace tactooth {

struct SessionEventsOptions {
    std::filesystem::path session;
    bool json = false;
};
/// Replays a recording and prints what happened in it, and when. Returns an ExitCode: negative if the replay differs
/// from the recording.
[[nodiscard]] int runSessionEvents(const SessionEventsOptions& options);

}  // namespace tactooth

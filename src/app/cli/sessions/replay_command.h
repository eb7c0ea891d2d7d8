// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/sessions/replay_film.h"
#include "session/recording/recording_seal.h"

namespace tactooth {

struct ReplayOptions {
    std::filesystem::path session;
    std::filesystem::path out;    ///< folder; empty: writes no files
    std::optional<double> until;  ///< s of the session
    bool json = false;
    std::optional<SealReport> seal;  ///< what is known of the seal of the recording, for the summary
    int pictures = 0;                ///< in `out`, evenly over the session
    FilmOptions film;
    std::string size = "1280x720";  ///< of pictures and film, as for `tactooth render`
    /// Direction, as for `tactooth render`; none: from where the session was looked at, else as a dentist looks.
    std::optional<std::string> view;
};

/// Simulates a recorded session again, as fast as this machine can, and compares it with the recording.
[[nodiscard]] int runReplay(const ReplayOptions& options);

}  // namespace tactooth

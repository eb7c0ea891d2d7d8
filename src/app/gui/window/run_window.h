// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "session/model/session_tooth.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {

/// What the window opens; a missing value means the built-in tooth or bur.
struct WindowOptions {
    std::optional<ToothSource> tooth;
    std::string workOn;                              ///< name of the tooth of a case; empty: the first
    std::optional<MouthChoice> mouth;                ///< a tooth in a whole mouth; excludes `tooth`
    std::optional<std::string> exercise;             ///< as findExercise finds it; excludes `tooth` and `mouth`
    std::optional<std::filesystem::path> recording;  ///< a recorded session to replay; excludes `tooth`
    std::optional<std::filesystem::path> bur;        ///< as findOrReadBur finds it
    std::filesystem::path recordings;                ///< where sessions are kept; empty: the user's folder
    bool records = true;                             ///< false: nothing is kept or restored
    std::string stream;                              ///< where each tick is sent (LiveStream::open); empty: nowhere
    bool sealed = false;                             ///< an examination; needs `records`
    std::map<std::string, std::string> settings;     ///< by their flags (see windowOptions); they override the file
    std::optional<std::string>
        device;  ///< see openDevice; if it does not open, the window says so and the mouse moves the bur
};

/// Opens the window and returns an ExitCode when it is closed. Without a display or OpenGL 4.1, or with unusable files,
/// it opens nothing and prints why on stderr.
[[nodiscard]] int runWindow(const WindowOptions& options);

}  // namespace tactooth

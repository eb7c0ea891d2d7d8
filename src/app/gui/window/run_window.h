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

/// What the window opens with; whatever is not given is the built-in one.
struct WindowOptions {
    std::optional<ToothSource> tooth;
    std::string workOn;                ///< tooth of a case; empty: the first
    std::optional<MouthChoice> mouth;  ///< the whole mouth around one of its teeth; `tooth` is not given then
    std::optional<std::filesystem::path> exercise;  ///< neither `tooth` nor `mouth` is given then
    std::optional<std::filesystem::path> bur;
    std::map<std::string, std::string> settings;  ///< by their flag (see windowOptions); they win over the file's
    std::optional<std::string> device;  ///< see openDevice; one that does not open leaves the mouse, and it is said
};

/// Opens the simulator's window and returns when it is closed: an ExitCode. Without a display or OpenGL 4.1, or with
/// files that cannot be used, it says so on stderr and opens nothing.
[[nodiscard]] int runWindow(const WindowOptions& options);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tactooth {

/// The arguments of the program without a command: they define how its window opens.
struct WindowArguments {
    std::string tooth;
    std::string workOn;
    std::vector<std::string> layers;
    std::string materials;
    std::string exercise;
    std::string bur;
    std::string recordings;
    bool noRecord = false;
    std::string stream;
    bool sealed = false;
    std::map<std::string, std::string> settings;  ///< the key is the flag
    std::optional<std::string> device;
    bool deviceInProcess = false;
    std::optional<int> mouth;  ///< tooth number
    bool noCache = false;
};

/// Adds the options of the window; `arguments` must live as long as `program`.
void addWindowArguments(CLI::App& program, WindowArguments& arguments);

/// Opens the window. Returns an ExitCode when the window closes.
[[nodiscard]] int runWindowCommand(const WindowArguments& arguments);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

namespace tactooth {

/// What the arguments ask for: filled while they are read, run once all of them were understood.
using CommandAction = std::function<int()>;

/// Adds the command `name` with its options; choosing it on the command line makes `run(options)` the thing to do.
template <class Options>
CLI::App* addCommand(CLI::App& program, CommandAction& chosen, const std::string& name, const std::string& description,
                     std::shared_ptr<Options> options, int (*run)(const Options&)) {
    CLI::App* command = program.add_subcommand(name, description)->group("Commands")->footer("");
    command->callback([&chosen, options, run] { chosen = [options, run] { return run(*options); }; });
    return command;
}

struct MouthSpec;
/// The options that choose a built-in mouth. `needed`: the option without which these mean nothing; null if there is
/// none.
void addMouthSpecOptions(CLI::App& command, MouthSpec& spec, CLI::Option* needed);

// Each adds the commands of one topic: those that its source file defines.

/// Cases of patients.
void addCaseCommands(CLI::App& program, CommandAction& chosen);
/// Changes of surfaces.
void addMeshCommands(CLI::App& program, CommandAction& chosen);
/// Shapes that the program makes by itself: teeth, burs and instruments.
void addMouthCommands(CLI::App& program, CommandAction& chosen);
/// Pictures.
void addPictureCommands(CLI::App& program, CommandAction& chosen);
/// Measurements, and the state of this machine and its devices.
void addMeasuringCommands(CLI::App& program, CommandAction& chosen);

}  // namespace tactooth

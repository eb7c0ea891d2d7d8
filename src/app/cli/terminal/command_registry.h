// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

namespace tactooth {

/// The action that the arguments request. The parser sets it; it runs once all arguments are parsed.
using CommandAction = std::function<int()>;

/// Adds the command `name` with its options. If the command line names it, `run(options)` becomes the action.
template <class Options>
CLI::App* addCommand(CLI::App& program, CommandAction& chosen, const std::string& name, const std::string& description,
                     std::shared_ptr<Options> options, int (*run)(const Options&)) {
    CLI::App* command = program.add_subcommand(name, description)->group("Commands")->footer("");
    command->callback([&chosen, options, run] { chosen = [options, run] { return run(*options); }; });
    return command;
}

struct MouthSpec;
/// Adds the options that select a built-in mouth. `needed`: the option that they require; null if there is none.
void addMouthSpecOptions(CLI::App& command, MouthSpec& spec, CLI::Option* needed);

/// Adds --seal. `record`: the option that it needs; null if there is none.
void addSealOption(CLI::App& command, bool& seal, CLI::Option* record);

// Each function adds the commands of one topic, which its source file defines.

/// Recorded sessions.
void addSessionCommands(CLI::App& program, CommandAction& chosen);
/// The assessment of a student's work.
void addAssessCommand(CLI::App& program, CommandAction& chosen);
void addCalibrateCommand(CLI::App& program, CommandAction& chosen);
void addLearnedCommand(CLI::App& program, CommandAction& chosen);
void addStudyCommand(CLI::App& program, CommandAction& chosen);
/// Patient cases.
void addCaseCommands(CLI::App& program, CommandAction& chosen);
/// Changes to surfaces.
void addMeshCommands(CLI::App& program, CommandAction& chosen);
/// Shapes that the program makes itself: teeth, burs and instruments.
void addMouthCommands(CLI::App& program, CommandAction& chosen);
/// Pictures.
void addPictureCommands(CLI::App& program, CommandAction& chosen);
/// Measurements, and the state of this machine and its devices.
void addMeasuringCommands(CLI::App& program, CommandAction& chosen);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/replay_command.h"
#include "app/cli/sessions/session_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/number_range.h"

namespace tactooth {
namespace {

template <class Options>
CLI::App* addForOneSession(CLI::App& parent, CommandAction& chosen, const char* name, const char* description,
                           const std::shared_ptr<Options>& options, int (*run)(const Options&)) {
    CLI::App* command = addCommand(parent, chosen, name, description, options, run);
    command->add_option("FILE", options->session, "Recorded session (*.ttsession)")->required()->type_name("");
    return command;
}

void addReplay(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = addForOneSession(
        program, chosen, "replay",
        "Simulates a recorded session again, as fast as it can, and compares tooth and forces with the recording: exit "
        "code 1 if they differ.",
        options, runReplay);
    command
        ->add_option(
            "--out", options->out,
            "Folder to make: cut.stl (the tooth), forces.csv (each tick) and summary.json (volumes, speed, hash)")
        ->type_name("DIR");
    command->add_option("--until", options->until, "Stops at this time of the session")
        ->transform(numberFrom(0.0, 1e6))
        ->type_name("S");
    command->add_flag("--verify", options->verify, "Only compares, and writes no files")->excludes("--out");
    command->add_flag("--json", options->json, "Writes the summary as JSON");
}

}  // namespace

void addSessionCommands(CLI::App& program, CommandAction& chosen) {
    addReplay(program, chosen);
    CLI::App* session = program.add_subcommand("session", "Works with recorded sessions.")->group("Commands");
    session->require_subcommand(1);
    const auto info = std::make_shared<SessionInfoOptions>();
    CLI::App* command =
        addForOneSession(*session, chosen, "info", "Prints what a recording holds.", info, runSessionInfo);
    command->add_flag("--json", info->json, "Writes one JSON object");
    const auto repair = std::make_shared<SessionRepairOptions>();
    command = addForOneSession(*session, chosen, "repair",
                               "Writes what is whole of a recording that was cut off, as a recording that ends there.",
                               repair, runSessionRepair);
    command->add_option("--out", repair->out, "File to write (*.ttsession)")->required()->type_name("FILE");
    const auto verify = std::make_shared<ReplayOptions>();
    verify->verify = true;
    command = addForOneSession(
        *session, chosen, "verify",
        "Replays a recording and tells whether it reaches the recorded tooth: exit code 1 if not.", verify, runReplay);
    command->add_flag("--json", verify->json, "Writes one JSON object");
}

}  // namespace tactooth

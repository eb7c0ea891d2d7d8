// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/replay_command.h"
#include "app/cli/sessions/session_command.h"
#include "app/cli/sessions/session_events_command.h"
#include "app/cli/sessions/session_export_command.h"
#include "app/cli/sessions/session_key_command.h"
#include "app/cli/sessions/session_trim_command.h"
#include "app/cli/sessions/session_verify_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/default_text.h"
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

/// The options of pictures and film.
void addPictures(CLI::App& command, ReplayOptions& options) {
    constexpr const char* kGroup = "Pictures";
    command
        .add_option("--pictures", options.pictures,
                    "Pictures of so many moments, evenly over the session, in the folder of --out")
        ->transform(wholeNumberFrom(1, 500))
        ->needs("--out")
        ->type_name("N")
        ->group(kGroup);
    CLI::Option* film = command.add_option("--film", options.film.file,
                                           "A film with the sound of the drill (.mp4, .mkv or .mov), by ffmpeg. Where "
                                           "that is not installed: a folder FILE.frames of pictures and a WAV file");
    film->type_name("FILE")->group(kGroup);
    command.add_option("--fps", options.film.fps, withDefault("Pictures each second of the film", options.film.fps))
        ->transform(wholeNumberFrom(1, 240))
        ->needs(film)
        ->type_name("N")
        ->group(kGroup);
    command
        .add_option("--speed", options.film.speed,
                    withDefault("Speed of the film; it has sound at 1 only", options.film.speed))
        ->transform(numberFrom(0.01, 100.0))
        ->needs(film)
        ->type_name("FACTOR")
        ->group(kGroup);
    command
        .add_option("--size", options.size, withDefault("Width and height of pictures and film, pixels", options.size))
        ->type_name("WxH")
        ->group(kGroup);
    command
        .add_option(
            "--view", options.view,
            "Direction of the view: occlusal, buccal, lingual, mesial, distal, dentist or AZIMUTH,ELEVATION in "
            "degrees (default: from where the session was looked at when it first showed the mouth mirror, else "
            "dentist)")
        ->type_name("NAME")
        ->group(kGroup);
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
    addPictures(*command, *options);
    // Every replay compares, so that nothing is left to do.
    command->add_flag_callback(
        "--verify", [] {},
        "Compares with the recording, as every replay does; without --out and --film no file is written");
    command->add_flag("--json", options->json, "Writes the summary as JSON");
}

void addEvents(CLI::App& session, CommandAction& chosen) {
    const auto events = std::make_shared<SessionEventsOptions>();
    CLI::App* command = addForOneSession(
        session, chosen, "events",
        "Replays a recording and lists what happened in it: burs, cuts, undos, resets, what the bur reached.", events,
        runSessionEvents);
    command->add_flag("--json", events->json, "Writes one JSON object");
}

void addExport(CLI::App& session, CommandAction& chosen) {
    CLI::App* parent = session.add_subcommand("export", "Replays a recording and writes it for other programs.");
    parent->require_subcommand(1);
    parent->get_formatter()->label("SUBCOMMAND", "FORMAT");
    const auto csv = std::make_shared<SessionExportOptions>();
    CLI::App* command = addForOneSession(*parent, chosen, "csv", "Writes a table with a row for each tick, as 'feel'.",
                                         csv, runSessionExportCsv);
    command->add_option("--out", csv->out, "CSV file to write")->required()->type_name("FILE");
    const auto mcap = std::make_shared<SessionExportOptions>();
    command = addForOneSession(*parent, chosen, "mcap",
                               "Writes an MCAP file, as Foxglove and PlotJuggler open it: /tool/pose, /tool/force, "
                               "/spindle and /events in JSON with schemas.",
                               mcap, runSessionExportMcap);
    command->add_option("--out", mcap->out, "MCAP file to write")->required()->type_name("FILE");
    command
        ->add_option("--rate", mcap->rateHz,
                     withDefault("Most messages a second on each channel but /events, Hz", mcap->rateHz))
        ->transform(numberFrom(0.1, 100000.0))
        ->type_name("HZ");
}

void addTrim(CLI::App& session, CommandAction& chosen) {
    const auto trim = std::make_shared<SessionTrimOptions>();
    CLI::App* command = addForOneSession(
        session, chosen, "trim",
        "Writes a part of a recording as a recording that can be replayed. Whole blocks of half a second are kept.",
        trim, runSessionTrim);
    command->add_option("--from", trim->from, withDefault("Start of the part, s", trim->from))
        ->transform(numberFrom(0.0, 1e6))
        ->type_name("S");
    command->add_option("--to", trim->to, "End of the part, s (default: that of the recording)")
        ->transform(numberFrom(0.0, 1e6))
        ->type_name("S");
    command->add_option("--out", trim->out, "File to write (*.ttsession)")->required()->type_name("FILE");
}

void addVerify(CLI::App& session, CommandAction& chosen) {
    const auto verify = std::make_shared<SessionVerifyOptions>();
    CLI::App* command =
        addForOneSession(session, chosen, "verify",
                         "Checks the signatures of a sealed recording; then replays it and checks whether it reaches "
                         "the recorded tooth: "
                         "exit code 1 if not, if a byte was changed, or if the end of a sealed recording is missing.",
                         verify, runSessionVerify);
    command
        ->add_option("--key", verify->key,
                     "Public key that must have signed it, as 'session key' shows it on the station. Without it, any "
                     "key counts, and so does a recording that nobody has signed")
        ->type_name("PUBLIC");
    command->add_flag("--json", verify->json, "Writes one JSON object");
}

void addKey(CLI::App& session, CommandAction& chosen) {
    const auto key = std::make_shared<SessionKeyOptions>();
    CLI::App* command = addCommand(session, chosen, "key",
                                   "Shows the public key with which this station seals recordings. Makes it at the "
                                   "first call, in the user's folder for data.",
                                   key, runSessionKey);
    command->add_flag("--json", key->json, "Writes one JSON object");
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
    addVerify(*session, chosen);
    addKey(*session, chosen);
    addEvents(*session, chosen);
    addExport(*session, chosen);
    addTrim(*session, chosen);
}

}  // namespace tactooth

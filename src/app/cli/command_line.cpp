// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>
#include <system_error>

#include "app/cli/cases/exercise_command.h"
#include "app/cli/cases/score_command.h"
#include "app/cli/mesh/info_command.h"
#include "app/cli/pictures/window_command.h"
#include "app/cli/runs/contact_command.h"
#include "app/cli/runs/cut_command.h"
#include "app/cli/runs/demo_command.h"
#include "app/cli/runs/feel_command.h"
#include "app/cli/runs/sound_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/default_text.h"
#include "app/cli/terminal/manual.h"
#include "app/cli/terminal/number_range.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/messages.h"
#include "app/gui/keys/key_page.h"
#include "assessment/metric_table.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "geometry/util/system_reason.h"
#include "session/io/material_file.h"
#include "tooth/model/material_registry.h"

namespace tactooth {
namespace {

// The force of 'feel' goes to no device, so it may be stiffer than any device can render.
constexpr double kMaxStiffness = 1000;  // N/mm: a tenth of a tooth
constexpr double kMostDamping = 100;    // N*s/mm
constexpr double kMaxFriction = 10;

void addInfo(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* command =
        addCommand(program, chosen, "info",
                   "Describes the surfaces in STL, OBJ and PLY files: size, whether they are closed, volume, findings.",
                   options, runInfo);
    command->add_option("FILE", options->files, "STL (binary or ASCII), OBJ or PLY files, mm")
        ->required()
        ->type_name("");
    command->add_flag("--json", options->json, "Writes one JSON object for each file, one in each line");
}

/// The option that feel, cut, demo and sound share.
void addMaterials(CLI::App& command, std::filesystem::path& file) {
    command
        .add_option("--materials", file,
                    "TOML file that changes the values of materials or adds materials (example: data/materials.toml)")
        ->type_name("FILE");
}

/// The option that feel, cut and demo share.
void addWorkOn(CLI::App& command, std::string& name) {
    command.add_option("--work-on", name, "Tooth of the case to work on, by name or FDI number (default: the first)")
        ->type_name("NAME");
}

/// The option that feel, cut and demo share.
CLI::Option* addRecord(CLI::App& command, std::filesystem::path& file, const std::string& more = {}) {
    return command
        .add_option("--record", file,
                    "File (*.ttsession) to record the run to, so that 'replay' reaches the same numbers; an older "
                    "recording of that name is replaced" +
                        more)
        ->type_name("FILE");
}

/// The option that contact and feel share.
void addTool(CLI::App& command, std::filesystem::path& tool) {
    command
        .add_option("--tool,--bur", tool,
                    "STL file of the tool, mm: tip at the origin, +z along the shaft; or the number of a bur "
                    "('tactooth bur --list')")
        ->required()
        ->type_name("NUMBER|FILE");
}

void addContact(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ContactOptions>();
    CLI::App* command =
        addCommand(program, chosen, "contact", "Computes the penetration depth of a tool in a tooth at single poses.",
                   options, runContact);
    command->add_option("--tooth", options->tooth, "STL file of the tooth, mm")->required()->type_name("FILE");
    addTool(*command, options->tool);
    command
        ->add_option("--poses", options->poses,
                     "CSV file t,x,y,z,qw,qx,qy,qz: poses of the tool in the tooth frame, s and mm")
        ->required()
        ->type_name("FILE");
    command->add_option("--out", options->out, "CSV file to write: t,touching,depth,nx,ny,nz,px,py,pz,contacts,micros")
        ->required()
        ->type_name("FILE");
}

void addFeel(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<FeelOptions>();
    CLI::App* command =
        addCommand(program, chosen, "feel", "Computes the force of each tick while a hand follows a trajectory.",
                   options, runFeel);
    command->add_option("--tooth,--case", options->tooth, "STL file of the tooth, mm, or a case")
        ->required()
        ->type_name("FILE");
    addWorkOn(*command, options->workOn);
    addTool(*command, options->tool);
    command
        ->add_option("--trajectory", options->trajectory, "CSV file t,x,y,z,qw,qx,qy,qz: poses of the hand, s and mm")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--out", options->out,
                     "CSV file to write, one row for each tick: depth, normal, force, torque, proxy")
        ->required()
        ->type_name("FILE");
    addMaterials(*command, options->materials);
    addSealOption(*command, options->seal, addRecord(*command, options->record));
    command
        ->add_option(
            "--mode", options->mode,
            "proxy: a tool that never enters the tooth (default); penalty: deepest pair of triangles, for comparison")
        ->check(CLI::IsMember({"proxy", "penalty"}))
        ->type_name("MODE");
    command
        ->add_option("--freedom", options->freedom,
                     "3: the proxy has the orientation of the hand (default); 6: contacts also turn it, as for a "
                     "device that renders torque")
        ->check(CLI::IsMember({3, 6}))
        ->type_name("DEGREES");
    command->add_option("--stiffness", options->stiffness, "Stiffness, N/mm (default: that of the material)")
        ->transform(numberFrom(0, kMaxStiffness))
        ->type_name("K");
    command->add_option("--damping", options->damping, "Damping, N*s/mm (default: that of the material)")
        ->transform(numberFrom(0, kMostDamping))
        ->type_name("C");
    command
        ->add_option("--friction", options->friction,
                     withDefault("Coulomb friction coefficient", options->friction, ", spring and damper alone"))
        ->transform(numberFrom(0, kMaxFriction))
        ->type_name("MU");
}

/// "t,enamel,dentin,...": the columns that `cut --removed` writes.
std::string removedColumns() {
    std::string columns = "t";
    for (const MaterialId id : builtinMaterials().byRole()) columns.append(",").append(builtinMaterials().nameOf(id));
    return columns;
}

void addCut(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<CutOptions>();
    CLI::App* command =
        addCommand(program, chosen, "cut", "Cuts a tooth with a spinning bur along a trajectory.", options, runCut);
    command
        ->add_option("--tooth,--case", options->tooth,
                     "Outer surface of the tooth (a closed STL file, mm), a case, or a tooth saved by --save")
        ->required()
        ->type_name("FILE");
    addWorkOn(*command, options->workOn);
    command
        ->add_option("--layer", options->layers,
                     "What is inside: " + builtinMaterials().names() +
                         ", or a material of --materials, each a closed STL file; may be given several times, inner "
                         "layers win")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    addMaterials(*command, options->materials);
    command->add_option("--material", options->material, "What a tooth without layers is made of (default: enamel)")
        ->type_name("NAME");
    command
        ->add_option("--tool,--bur", options->tool,
                     "The bur: its number ('tactooth bur --list'), an STL file (mm, tip at the origin, +z along the "
                     "shaft) or its TOML description (default: the bur of the case)")
        ->type_name("NUMBER|FILE");
    command
        ->add_option("--trajectory", options->trajectory, "CSV file t,x,y,z,qw,qx,qy,qz: poses of the hand, s and mm")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--speed-rpm", options->speedRpm,
                     "Speed of the bur, rev/min; a bur that does not spin cuts nothing")
        ->required()
        ->transform(numberFrom(0.0, 1e6))
        ->type_name("N");
    command
        ->add_option(
            "--voxel", options->voxel,
            withDefault("Voxel size of the cut volume, mm", CutOptions::kUsualVoxel, ", or that of the saved tooth"))
        ->transform(numberFrom(0.005, 0.5))
        ->type_name("MM");
    command
        ->add_option("--feed", options->feed,
                     "law: the material limits the feed rate (default); rigid: the bur removes all that it sweeps")
        ->check(CLI::IsMember({"law", "rigid"}))
        ->type_name("FEED");
    command->add_option("--out", options->out, "STL file to write: the cut tooth")->required()->type_name("FILE");
    command
        ->add_option("--save", options->save,
                     "File (*.tactooth) to save the tooth to, with its layers and cuts; --tooth opens it to continue")
        ->type_name("FILE");
    addSealOption(*command, options->seal, addRecord(*command, options->record));
    command->add_option("--forces", options->forces, "CSV file to write, one row for each tick, as by 'feel'")
        ->type_name("FILE");
    command
        ->add_option("--events", options->events,
                     "CSV file to write: t,event,x,y,z for first contact, dentin reached, pulp near, pulp exposed, "
                     "neighbour touched, "
                     "gum or bone touched, cut beside the tooth, piece came loose (not with --feed rigid), bur stalled")
        ->type_name("FILE");
    command
        ->add_option(
            "--removed", options->removed,
            "CSV file to write: " + removedColumns() + " and each material of --materials, mm^3 since the start")
        ->type_name("FILE");
    command
        ->add_option("--export-layers", options->layersOut,
                     "Folder for what remains of each layer: one closed STL file for each, named after it")
        ->type_name("DIR");
    command
        ->add_option("--vdb", options->vdb,
                     "OpenVDB file to write: the volume fraction of each material, one grid for each, mm (only if "
                     "built with OpenVDB)")
        ->type_name("FILE");
}

void addExercise(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ExerciseOptions>();
    CLI::App* command = addCommand(
        program, chosen, "exercise",
        "Reads and checks an exercise, built in or a TOML file (docs/exercises.md), and shows what it asks for.",
        options, runExercise);
    command
        ->add_option(
            "EXERCISE", options->exercise,
            "TOML file of the exercise, which the window opens by --exercise FILE; or a built-in one, as class-1-46")
        ->required()
        ->type_name("");
    command->add_option("--out", options->out, "STL file to write: the ideal shape")->type_name("FILE");
}

void addScore(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ScoreOptions>();
    CLI::App* command = addCommand(
        program, chosen, "score", "Compares a cut tooth with an ideal cavity: what was cut inside it and what outside.",
        options, runScore);
    command->add_option("FILE", options->tooth, "Saved tooth, from 'cut --save' or the window (Ctrl+S)")
        ->required()
        ->type_name("");
    command
        ->add_option(
            "--target", options->target,
            "Ideal shape in the same frame: an STL, OBJ or PLY file (mm), or a tooth that an expert has cut and saved")
        ->required()
        ->type_name("FILE");
    command->add_flag("--json", options->json, "Writes one JSON object instead of a table");
}

void addDemo(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<DemoOptions>();
    CLI::App* command =
        addCommand(program, chosen, "demo",
                   "Plays a session that touches and cuts a tooth, and writes pictures, sound, plot, table, the cut "
                   "tooth, a recording and a summary to a folder. Needs no display, device or sound card.",
                   options, runDemo);
    command->add_option("--out", options->out, "Folder to write to")->required()->type_name("DIR");
    command->add_option("--seconds", options->seconds, withDefault("Length of the session, s", options->seconds))
        ->transform(numberFrom(1.0, 600.0))
        ->type_name("S");
    (void)addRecord(*command, options->record, " (the folder has session.ttsession in any case)");
    addSealOption(*command, options->seal, nullptr);
    addMaterials(*command, options->materials);
    command
        ->add_option("--tooth,--case", options->tooth,
                     "A closed STL file (mm, crown toward +z) or a case (default: the built-in molar)")
        ->type_name("FILE");
    addWorkOn(*command, options->workOn);
    command->add_option("--layer", options->layers, "Layer inside --tooth, as for 'cut'")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->needs("--tooth");
    command->add_flag("--mouth", options->mouth, "Uses the built-in molar in the whole mouth, with neighbours and gums")
        ->excludes("--tooth");
    command
        ->add_option("--bur", options->bur,
                     "The bur: its number ('tactooth bur --list'), an STL file (mm, tip at the origin, +z along the "
                     "shaft) or its TOML description (default: the bur of the case, else the fissure bur 57)")
        ->type_name("NUMBER|FILE");
}

void addSound(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<SoundOptions>();
    CLI::App* command = addCommand(
        program, chosen, "sound",
        "Renders the sound of a bur from its speed, removal power and material over time. Needs no sound card.",
        options, runSound);
    command
        ->add_option("--profile", options->profile,
                     "CSV file t,speed_rpm,power,material: s, rev/min, W, and " + dentalMaterials().names() +
                         ", a material of --materials, or none")
        ->required()
        ->type_name("FILE");
    addMaterials(*command, options->materials);
    command->add_option("--out", options->out, "WAV file to write: 48 kHz, 16 bits, stereo")
        ->required()
        ->type_name("FILE");
    command->add_option("--spectrogram", options->spectrogram, "PNG file to write: the spectrogram")->type_name("FILE");
    command->add_option("--drive", options->drive, "turbine (default), electric (1:5) or low-speed (contra-angle)")
        ->check(CLI::IsMember({"turbine", "electric", "low-speed"}))
        ->type_name("DRIVE");
    command
        ->add_option("--sounds", options->sounds,
                     "Your own sounds: a recording (WAV, FLAC, Ogg) of the drive without load, or a TOML preset that "
                     "names a recording for each part (docs/sound.md)")
        ->type_name("FILE");
    command
        ->add_option(
            "--blades", options->blades,
            withDefault("Number of blades of a carbide bur, heard at low speed", options->blades, ", a diamond bur"))
        ->transform(wholeNumberFrom(0, 60))
        ->type_name("N");
    command->add_flag("--water", options->water, "Adds the cooling spray while the drive runs");
    command->add_flag("--suction", options->suction, "Adds the suction in the mouth");
    command->add_flag("--room", options->room, "Adds the sound of the surgery around the chair");
    command->add_flag("--headphones", options->headphones,
                      "Places the sound by head-related transfer functions (HRTF) instead of stereo panning");
}

struct ManualOptions {
    std::string form;
    const CLI::App* program = nullptr;  ///< outlives the command
};

int runManual(const ManualOptions& options) {
    const CLI::App& program = *options.program;
    print("{}", options.form == "metrics"      ? metricsPage(Language::English)
                : options.form == "metrics-ja" ? metricsPage(Language::Japanese)
                : options.form == "keys"       ? keyPageFile(Language::English)
                : options.form == "keys-ja"    ? keyPageFile(Language::Japanese)
                : options.form == "bash"       ? bashCompletion(program)
                : options.form == "markdown"   ? commandsPage(program)
                                               : manPage(program, TACTOOTH_VERSION));
    return kExitOk;
}

void addManual(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ManualOptions>();
    options->program = &program;
    addCommand(program, chosen, "manual", "Prints the manual of all commands in one of several forms.", options,
               runManual)
        ->add_option("FORM", options->form,
                     "man: a man page; bash: a completion script for bash; markdown: the page docs/user/commands.md; "
                     "metrics and metrics-ja: the pages docs/user/metrics.md and metrics.ja.md; keys and keys-ja: the "
                     "pages docs/user/keys.md and keys.ja.md")
        ->required()
        ->check(CLI::IsMember({"man", "bash", "markdown", "metrics", "metrics-ja", "keys", "keys-ja"}))
        ->type_name("");
}

/// Output that could not be written (a full disk, a closed pipe) must not be reported as success.
int withOutputFlushed(int exitCode) {
    const int reason = outputError();
    if (reason == 0 || exitCode == kExitBadInput) return exitCode;
    return reportError(reason < 0 ? Error(msg::kOutputLost) : Error(msg::kOutputLostBecause, systemReason(reason)));
}

void replaceFirst(std::string& text, std::string_view what, std::string_view by) {
    if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

/// Rewrites "--mode: rigd not in {law,rigid}" as a plain sentence.
std::string asChoice(const std::string& message) {
    constexpr std::string_view kNotIn = " not in {";
    const std::size_t colon = message.find(": "), notIn = message.rfind(kNotIn);
    if (colon == std::string::npos || notIn == std::string::npos || notIn < colon + 2) return message;
    const std::string found = message.substr(colon + 2, notIn - colon - 2);
    std::string choices = message.substr(notIn + kNotIn.size());
    choices.erase(choices.find_last_not_of('}') + 1);
    return message.substr(0, colon) + " must be one of " + choices + ", but is " + quotedWord(found);
}

/// Rewrites CLI11's message as one sentence that refers to the help.
Error usageError(const CLI::App& program, const CLI::ParseError& error) {
    constexpr std::size_t kLongest = 300;  // characters: an argument may be the text of a whole file
    std::string command = "tactooth";
    for (auto chosen = program.get_subcommands(); !chosen.empty(); chosen = chosen.front()->get_subcommands()) {
        command.append(" ").append(chosen.front()->get_name());
    }
    std::string sentence = error.what();
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    if (error.get_name() == "ExcludesError") replaceFirst(sentence, " excludes ", " cannot be given together with ");
    if (error.get_name() == "ValidationError") {
        replaceFirst(sentence, ": must be ", " must be ");
        sentence = asChoice(sentence);
    }
    return {msg::kUsageHelp, displayShort(sentence, kLongest), command};
}

}  // namespace

void addSealOption(CLI::App& command, bool& seal, CLI::Option* record) {
    CLI::Option* option =
        command.add_flag("--seal", seal, "Signs the recording with the key of this station, which 'session key' shows");
    if (record != nullptr) option->needs(record);
}

int runCommandLine(int argc, const char* const* argv) {
    CLI::App program("Tactooth, a dental drilling simulator: see, feel and hear a bur cut a real tooth.", "tactooth");
    program.set_version_flag("--version", "tactooth " TACTOOTH_VERSION, "Print the version and exit");
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.footer("'tactooth COMMAND --help' describes a command.");
    program.get_formatter()->column_width(28);
    program.get_formatter()->label("SUBCOMMAND", "COMMAND");
    program.require_subcommand(0, 1);
    WindowArguments window;
    addWindowArguments(program, window);
    CommandAction chosen = [&window] { return runWindowCommand(window); };
    addInfo(program, chosen);
    addContact(program, chosen);
    addFeel(program, chosen);
    addCut(program, chosen);
    addExercise(program, chosen);
    addScore(program, chosen);
    addAssessCommand(program, chosen);
    addCalibrateCommand(program, chosen);
    addLearnedCommand(program, chosen);
    addStudyCommand(program, chosen);
    addDemo(program, chosen);
    addSound(program, chosen);
    addSessionCommands(program, chosen);
    addCaseCommands(program, chosen);
    addMouthCommands(program, chosen);
    addPictureCommands(program, chosen);
    addMeshCommands(program, chosen);
    addMeasuringCommands(program, chosen);
    addManual(program, chosen);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {  // --help or --version
        std::ostringstream text;
        const int exitCode = program.exit(help, text, text);
        writeTo(stdout, text.str());
        return withOutputFlushed(exitCode);
    } catch (const CLI::ParseError& error) {
        return reportError(usageError(program, error));
    }
    return withOutputFlushed(chosen());
}

}  // namespace tactooth

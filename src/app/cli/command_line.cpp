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
#include "app/cli/terminal/number_range.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/messages.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

// What 'feel' computes with is no device's force, so it may be harder than any device renders.
constexpr double kMaxStiffness = 1000;  // N/mm: a tenth of a tooth
constexpr double kMostDamping = 100;    // N*s/mm
constexpr double kMaxFriction = 10;

void addInfo(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* command =
        addCommand(program, chosen, "info",
                   "Shows what the surfaces in STL, OBJ and PLY files are like: size, closed or not, volume, findings.",
                   options, runInfo);
    command->add_option("FILE", options->files, "STL (binary or ASCII), OBJ or PLY files, in mm")
        ->required()
        ->type_name("");
    command->add_flag("--json", options->json, "Write one JSON object for each file, one a line");
}

/// The option that feel, cut and demo share.
void addMaterials(CLI::App& command, std::filesystem::path& file) {
    command
        .add_option("--materials", file, "TOML file that changes the materials' numbers (pattern: data/materials.toml)")
        ->type_name("FILE");
}

/// The option that feel, cut and demo share.
void addWorkOn(CLI::App& command, std::string& name) {
    command.add_option("--work-on", name, "The tooth of a case to work on, by name or FDI number (default: the first)")
        ->type_name("NAME");
}

void addContact(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ContactOptions>();
    CLI::App* command =
        addCommand(program, chosen, "contact",
                   "How deep a tool stands in a tooth at single poses, and the shortest way out.", options, runContact);
    command->add_option("--tooth", options->tooth, "The tooth's STL file, mm")->required()->type_name("FILE");
    command->add_option("--tool", options->tool, "The tool's STL file, mm: tip at the origin, +z along the shaft")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--poses", options->poses, "CSV file t,x,y,z,qw,qx,qy,qz: the tool in the tooth's frame, s and mm")
        ->required()
        ->type_name("FILE");
    command->add_option("--out", options->out, "CSV file to write: t,touching,depth,nx,ny,nz,px,py,pz,contacts,micros")
        ->required()
        ->type_name("FILE");
}

void addFeel(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<FeelOptions>();
    CLI::App* command = addCommand(program, chosen, "feel",
                                   "What a hand that follows a trajectory feels, tick by tick.", options, runFeel);
    command->add_option("--tooth,--case", options->tooth, "The tooth's STL file, mm, or a case")
        ->required()
        ->type_name("FILE");
    addWorkOn(*command, options->workOn);
    command->add_option("--tool", options->tool, "The tool's STL file, mm: tip at the origin, +z along the shaft")
        ->required()
        ->type_name("FILE");
    command->add_option("--trajectory", options->trajectory, "CSV file t,x,y,z,qw,qx,qy,qz: the hand's way, s and mm")
        ->required()
        ->type_name("FILE");
    command->add_option("--out", options->out, "CSV file to write, one row a tick: depth, normal, force, torque, proxy")
        ->required()
        ->type_name("FILE");
    addMaterials(*command, options->materials);
    command
        ->add_option("--mode", options->mode,
                     "proxy: never enters the tooth (default); penalty: deepest pair of triangles, for comparison")
        ->check(CLI::IsMember({"proxy", "penalty"}))
        ->type_name("MODE");
    command
        ->add_option("--freedom", options->freedom,
                     "3: the proxy turns as the hand does (default); 6: it also gives way by turning, as for a device "
                     "that renders torque")
        ->check(CLI::IsMember({3, 6}))
        ->type_name("DEGREES");
    command->add_option("--stiffness", options->stiffness, "Spring, N/mm (default: the material's)")
        ->transform(numberFrom(0, kMaxStiffness))
        ->type_name("K");
    command->add_option("--damping", options->damping, "Damper, N*s/mm (default: the material's)")
        ->transform(numberFrom(0, kMostDamping))
        ->type_name("C");
    command
        ->add_option("--friction", options->friction,
                     "Coulomb friction coefficient (default: 0, the bare spring and damper)")
        ->transform(numberFrom(0, kMaxFriction))
        ->type_name("MU");
}

void addCut(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<CutOptions>();
    CLI::App* command =
        addCommand(program, chosen, "cut", "Cuts a tooth with a spinning bur along a trajectory.", options, runCut);
    command
        ->add_option("--tooth,--case", options->tooth,
                     "The tooth's outer surface, a closed STL file, mm, a case, or a tooth that --save has saved")
        ->required()
        ->type_name("FILE");
    addWorkOn(*command, options->workOn);
    command
        ->add_option("--layer", options->layers,
                     "What is inside: enamel, dentin, pulp, caries, restoration or other, each a closed STL file; may "
                     "be given several times, inner layers win")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    addMaterials(*command, options->materials);
    command->add_option("--material", options->material, "What a tooth without layers is made of (default: enamel)")
        ->type_name("NAME");
    command
        ->add_option("--tool", options->tool,
                     "The bur's STL file, mm: tip at the origin, +z along the shaft, or its TOML description "
                     "(default: the case's own)")
        ->type_name("FILE");
    command->add_option("--trajectory", options->trajectory, "CSV file t,x,y,z,qw,qx,qy,qz: the hand's way, s and mm")
        ->required()
        ->type_name("FILE");
    command->add_option("--speed-rpm", options->speedRpm, "Speed of the bur, rev/min; a bur at rest cuts nothing")
        ->required()
        ->transform(numberFrom(0.0, 1e6))
        ->type_name("N");
    command
        ->add_option("--voxel", options->voxel,
                     "Spacing of the cut volume, mm (default: 0.025, or that of a saved tooth)")
        ->transform(numberFrom(0.005, 0.5))
        ->type_name("MM");
    command
        ->add_option("--feed", options->feed, "law: the material resists (default); rigid: everything on the way goes")
        ->check(CLI::IsMember({"law", "rigid"}))
        ->type_name("FEED");
    command->add_option("--out", options->out, "STL file to write: the cut tooth")->required()->type_name("FILE");
    command
        ->add_option("--save", options->save,
                     "File to save the tooth to, with its layers and all that was cut: --tooth takes it to cut on; "
                     "name it *.tactooth")
        ->type_name("FILE");
    command->add_option("--forces", options->forces, "CSV file to write, one row a tick, as 'feel' does")
        ->type_name("FILE");
    command
        ->add_option(
            "--events", options->events,
            "CSV file to write: t,event,x,y,z for first contact, dentin reached, pulp exposed, neighbour touched, "
            "gum or bone touched, cut beside the tooth, piece came loose (none of these with --feed rigid, which takes "
            "only what the bur "
            "sweeps), bur stalled")
        ->type_name("FILE");
    command
        ->add_option("--removed", options->removed,
                     "CSV file to write: t,enamel,dentin,pulp,caries,other, mm^3 since the start")
        ->type_name("FILE");
    command
        ->add_option("--export-layers", options->layersOut,
                     "Folder to write what is left of each layer to, one closed STL file a layer, named after it")
        ->type_name("DIR");
    command
        ->add_option("--vdb", options->vdb,
                     "OpenVDB file to write: how much of each voxel every material fills, one grid a material, mm; "
                     "only in programs built with OpenVDB")
        ->type_name("FILE");
}

void addExercise(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ExerciseOptions>();
    CLI::App* command =
        addCommand(program, chosen, "exercise",
                   "What an exercise of your own asks for: reads and checks its TOML file (docs/exercises.md).",
                   options, runExercise);
    command->add_option("FILE", options->file, "The exercise; the window opens it with --exercise FILE")
        ->required()
        ->type_name("");
    command->add_option("--out", options->out, "Write the ideal shape as STL")->type_name("FILE");
}

void addScore(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ScoreOptions>();
    CLI::App* command =
        addCommand(program, chosen, "score",
                   "How much of an ideal cavity was cut from a tooth, and what was cut beside it.", options, runScore);
    command->add_option("FILE", options->tooth, "The tooth, as 'cut --save' or the window (Ctrl+S) has saved it")
        ->required()
        ->type_name("");
    command
        ->add_option(
            "--target", options->target,
            "The ideal shape in the same frame: an STL, OBJ or PLY file, mm, or a tooth that an expert has cut "
            "and saved")
        ->required()
        ->type_name("FILE");
    command->add_flag("--json", options->json, "Write one JSON object instead of a table");
}

void addDemo(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<DemoOptions>();
    CLI::App* command = addCommand(
        program, chosen, "demo",
        "Plays a session that touches and cuts a tooth, and leaves pictures, sound, plot, table, the cut tooth "
        "and a summary in a folder; needs no display, device or sound card.",
        options, runDemo);
    command->add_option("--out", options->out, "Folder for what the session leaves")->required()->type_name("DIR");
    command->add_option("--seconds", options->seconds, "Length of the session, s (default: 14)")
        ->transform(numberFrom(1.0, 600.0))
        ->type_name("S");
    addMaterials(*command, options->materials);
    command
        ->add_option("--tooth,--case", options->tooth,
                     "A closed STL file, mm, crown up (+z), or a case (default: the built-in molar)")
        ->type_name("FILE");
    addWorkOn(*command, options->workOn);
    command->add_option("--layer", options->layers, "What is inside --tooth, as for 'cut'")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->needs("--tooth");
    command->add_flag("--mouth", options->mouth, "The built-in molar in the whole mouth, with neighbours and gums")
        ->excludes("--tooth");
    command
        ->add_option(
            "--bur", options->bur,
            "An STL file, mm: tip at the origin, +z along the shaft, or its TOML description (default: the case's own, "
            "else the built-in fissure bur 57)")
        ->type_name("FILE");
}

void addSound(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<SoundOptions>();
    CLI::App* command =
        addCommand(program, chosen, "sound",
                   "What a bur sounds like whose speed, removal power and material a file tells over time; needs no "
                   "sound card.",
                   options, runSound);
    command
        ->add_option("--profile", options->profile,
                     "CSV file t,speed_rpm,power,material: s, rev/min, W, and enamel, dentin, pulp, caries, amalgam, "
                     "composite, restoration, other or none")
        ->required()
        ->type_name("FILE");
    command->add_option("--out", options->out, "WAV file to write: 48 kHz, 16 bits, stereo")
        ->required()
        ->type_name("FILE");
    command->add_option("--spectrogram", options->spectrogram, "PNG file to write: the frequencies over time")
        ->type_name("FILE");
    command->add_option("--drive", options->drive, "turbine (default), electric (1:5) or low-speed (contra-angle)")
        ->check(CLI::IsMember({"turbine", "electric", "low-speed"}))
        ->type_name("DRIVE");
    command
        ->add_option("--sounds", options->sounds,
                     "Your own sounds: a recording (WAV, FLAC, Ogg) of the drive running free, or a TOML preset that "
                     "names a recording for each part (pattern: docs/sound.md)")
        ->type_name("FILE");
    command
        ->add_option("--blades", options->blades,
                     "Of a carbide bur, whose passing is heard at low speed (default: 0, a diamond)")
        ->transform(wholeNumberFrom(0, 60))
        ->type_name("N");
    command->add_flag("--water", options->water, "Add the cooling spray, as long as the drive has air or current");
    command->add_flag("--suction", options->suction, "Add the suction in the mouth");
    command->add_flag("--headphones", options->headphones,
                      "Place the sound by the ears' own filtering (HRTF) instead of by left-right balance");
}

/// Output that could not be written (a full disk, a closed pipe) must not look like success.
int withOutputFlushed(int exitCode) {
    const int reason = outputError();
    if (reason == 0 || exitCode == kExitBadInput) return exitCode;
    return reportError(reason < 0 ? Error(msg::kOutputLost) : Error(msg::kOutputLostBecause, systemReason(reason)));
}

void replaceFirst(std::string& text, std::string_view what, std::string_view by) {
    if (const auto at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

/// "--mode: rigd not in {law,rigid}" as a person says it.
std::string asChoice(const std::string& message) {
    constexpr std::string_view kNotIn = " not in {";
    const std::size_t colon = message.find(": "), notIn = message.rfind(kNotIn);
    if (colon == std::string::npos || notIn == std::string::npos || notIn < colon + 2) return message;
    const std::string found = message.substr(colon + 2, notIn - colon - 2);
    std::string choices = message.substr(notIn + kNotIn.size());
    choices.erase(choices.find_last_not_of('}') + 1);
    return message.substr(0, colon) + " must be one of " + choices + ", but is " + quotedWord(found);
}

/// CLI11's message as one sentence that says where help is.
Error usageError(const CLI::App& program, const CLI::ParseError& error) {
    constexpr std::size_t kLongest = 300;  // characters: an argument may be a whole file
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

int runCommandLine(int argc, const char* const* argv) {
    CLI::App program("Tactooth, a dental drilling simulator: see, feel and hear a bur cut a real tooth.", "tactooth");
    program.set_version_flag("--version", "tactooth " TACTOOTH_VERSION, "Print the version and exit");
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.footer("'tactooth COMMAND --help' tells more about a command.");
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
    addDemo(program, chosen);
    addSound(program, chosen);
    addCaseCommands(program, chosen);
    addMouthCommands(program, chosen);
    addPictureCommands(program, chosen);
    addMeshCommands(program, chosen);
    addMeasuringCommands(program, chosen);
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

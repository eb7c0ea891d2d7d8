// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_contact_command.h"
#include "app/cli/measure/bench_cut_command.h"
#include "app/cli/measure/bench_slot_command.h"
#include "app/cli/measure/bench_stability_command.h"
#include "app/cli/measure/bench_view_command.h"
#include "app/cli/measure/reproduce_command.h"
#include "app/cli/runs/devices_command.h"
#include "app/cli/runs/doctor_command.h"
#include "app/cli/runs/realtime_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/number_range.h"
#include "devices/base/device_presets.h"
#include "experiments/stability.h"

namespace tactooth {
namespace {

/// Adds the option for one tooth to measure on. `form`: the contents of its file.
void addLargeTooth(CLI::App& command, std::filesystem::path& file, const std::string& form) {
    command
        .add_option("--tooth", file,
                    form +
                        " (default: a tooth of 325,312 triangles: a real one from $TACTOOTH_DATA or ../shared/data, "
                        "else a built-in one)")
        ->type_name("FILE");
}

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
    return text;
}

void addJson(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Writes one JSON object instead of a table");
}

void addRate(CLI::App& command, double& rateHz) {
    command.add_option("--rate", rateHz, "Ticks per second (default: 1000)")
        ->transform(numberFrom(500.0, 4000.0))
        ->type_name("HZ");
}

void addBenchContact(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchContactOptions>();
    CLI::App* command = addCommand(bench, chosen, "contact",
                                   "Measures the time of a contact tick while a bur approaches a tooth, presses, "
                                   "slides and leaves, at 1 and 10 cm/s, for several teeth and resolutions.",
                                   options, runBenchContact);
    command
        ->add_option("--tooth", options->tooth,
                     "A closed STL file, mm, crown up (default: an incisor, a molar, a canine and a tooth of 325,312 "
                     "triangles: real ones from $TACTOOTH_DATA or ../shared/data, else built-in ones)")
        ->type_name("FILE");
    command
        ->add_option("--tool", options->tool,
                     "An STL file, mm: tip at the origin, +z along the shaft (default: a round bur of 336 triangles)")
        ->type_name("FILE");
    command
        ->add_option("--resolution", options->resolutions,
                     "Percent of the triangles of the tooth; may be repeated (default: 6, 12, 25, 50 and 100)")
        ->transform(wholeNumberFrom(1, 100))
        ->type_name("PERCENT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--freedom", options->freedom, "Degrees of freedom of the proxy: 3 (default) or 6")
        ->check(CLI::IsMember({3, 6}))
        ->type_name("DEGREES");
    command
        ->add_option("--repeat", options->repeat,
                     "Number of runs of each case; the shortest time of each tick counts (default: 3)")
        ->transform(wholeNumberFrom(1, 100))
        ->type_name("N");
    addJson(*command, options->json);
}

void addBenchCut(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchCutOptions>();
    CLI::App* command = addCommand(bench, chosen, "cut",
                                   "Measures the time of ticks and of surface updates while a bur mills slots as deep "
                                   "as its head, for burs of 0.5 to 2.3 mm and voxels of 100 to 15 um.",
                                   options, runBenchCut);
    addLargeTooth(*command, options->tooth, "A closed STL file, mm, crown up");
    command->add_option("--voxel", options->voxels, "Voxel size of the cut volume, um; may be repeated")
        ->transform(numberFrom(5.0, 500.0))
        ->type_name("UM")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--diameter", options->diameters, "Diameter of a round bur, mm; may be repeated")
        ->transform(numberFrom(0.3, 5.0))
        ->type_name("MM")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--cores", options->cores, "Number of cores for carving (default: 1)")
        ->transform(wholeNumberFrom(1, 256))
        ->type_name("N");
    addJson(*command, options->json);
}

void addBenchSlot(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchSlotOptions>();
    CLI::App* command =
        addCommand(bench, chosen, "slot",
                   "Measures the time of a tick and the ripple of the force while a bur without rotation, and then a "
                   "probe, rests, trembles, slides and turns in a slot that was just cut.",
                   options, runBenchSlot);
    addLargeTooth(*command, options->tooth, "A closed STL file, mm, crown up");
    command->add_option("--voxel", options->voxel, "Voxel size of the cut volume, um (default: 25)")
        ->transform(numberFrom(5.0, 500.0))
        ->type_name("UM");
    addJson(*command, options->json);
}

void addBenchView(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchViewOptions>();
    CLI::App* command = addCommand(bench, chosen, "view",
                                   "Measures the time of a picture of a large tooth, of a whole mouth with mirror and "
                                   "of a bur that cuts, each against a simpler picture. Needs no display.",
                                   options, runBenchView);
    addLargeTooth(*command, options->tooth, "An STL file, mm");
    command->add_option("--size", options->size, "Size in pixels (default: 1280x800)")->type_name("WxH");
    command->add_option("--frames", options->frames, "Number of pictures of each case (default: 60)")
        ->transform(wholeNumberFrom(1, 10000))
        ->type_name("N");
    command->add_flag("--mouth", options->mouth, "Measures the mouth alone: 32 teeth, gums and a mirror")
        ->excludes("--tooth");
    addJson(*command, options->json);
}

void addBenchStability(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchStabilityOptions>();
    CLI::App* command = addCommand(bench, chosen, "stability",
                                   "Checks whether the force is stable: simulated devices and hands tap, press, slide, "
                                   "tremble, cut and let go in the closed loop. Exit code 1 if a run is unstable.",
                                   options, runBenchStability);
    const auto addNames = [&](const char* name, std::vector<std::string>& into, const std::string& help,
                              const std::set<std::string>& known) {
        command->add_option(name, into, help)
            ->check(CLI::IsMember(known))
            ->type_name("NAME")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    std::vector<std::string> models;
    for (const DevicePreset& preset : devicePresets()) models.emplace_back(preset.name);
    addNames("--device", options->devices, alternatives(models) + "; may be repeated", {models.begin(), models.end()});
    addNames("--hand", options->hands, "loose, nominal or firm", {"loose", "nominal", "firm"});
    std::set<std::string> materials;
    std::string names;
    for (const std::optional<MaterialId>& material : stabilityMaterials()) {
        materials.emplace(materialNameOf({.material = material}));
        if (material) names += builtinMaterials().nameOf(*material) + ", ";
    }
    addNames("--material", options->materials, (names + "or stiffest: a spring as stiff as the device bears").c_str(),
             materials);
    addNames("--situation", options->situations, "tap, press (1 N), limit, cusp, fissure, slot, let-go, cut or tremor",
             {"tap", "press", "limit", "cusp", "fissure", "slot", "let-go", "cut", "tremor"});
    addRate(*command, options->rateHz);
    command->add_flag("--all", options->all, "Prints a line for each run instead of one for each device and hand");
    addJson(*command, options->json);
}

void addBench(CLI::App& program, CommandAction& chosen) {
    CLI::App* bench = program.add_subcommand("bench", "Measures times on this machine.");
    bench->group("Commands")->footer("")->require_subcommand(1);
    bench->get_formatter()->label("SUBCOMMAND", "WHAT");
    addBenchContact(*bench, chosen);
    addBenchCut(*bench, chosen);
    addBenchSlot(*bench, chosen);
    addBenchView(*bench, chosen);
    addBenchStability(*bench, chosen);
}

void addRealtime(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<RealtimeOptions>();
    CLI::App* command = addCommand(program, chosen, "realtime",
                                   "Measures how well this machine keeps time while a simulated hand touches and cuts "
                                   "the built-in molar, and what tactooth-hand adds to a force's time. Exit code 1 "
                                   "if it misses more than 1 % of the deadlines.",
                                   options, runRealtime);
    command->add_option("--seconds", options->seconds, "Length of the run, s (default: 20)")
        ->transform(numberFrom(1.0, 3600.0))
        ->type_name("S");
    addRate(*command, options->rateHz);
    command->add_flag("--load", options->load, "Keeps all other cores busy meanwhile");
    CLI::Option* record =
        command
            ->add_option(
                "--record", options->record,
                "File (*.ttsession) to record the session to; see 'replay'; an older recording of that name is "
                "replaced")
            ->type_name("FILE");
    addSealOption(*command, options->seal, record);
    command
        ->add_option("--stream", options->stream,
                     "Sends the newest tick up to 1000 times a second to udp://HOST:PORT (docs/live-stream.md)")
        ->type_name("URL");
    addJson(*command, options->json);
}

void addDevices(CLI::App& program, CommandAction& chosen) {
    const auto devices = std::make_shared<DevicesOptions>();
    addCommand(program, chosen, "devices",
               "Lists the devices, what each can do, and what to do about those that cannot be used.", devices,
               runDevices)
        ->add_flag("--json", devices->json, "Writes one JSON array instead of lines");
    const auto doctor = std::make_shared<DoctorOptions>();
    addCommand(
        program, chosen, "doctor",
        "Checks display, OpenGL, sound, real-time rights, the hand process with its last faults, and devices, and "
        "says what to do about problems. Exit code 1 if the window cannot open.",
        doctor, runDoctor)
        ->add_flag("--json", doctor->json, "Writes one JSON array instead of lines");
}

void addReproduce(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ReproduceOptions>();
    CLI::App* command =
        addCommand(program, chosen, "reproduce",
                   "Repeats published measurements on this machine and writes tables (CSV), plots (PNG) and one page "
                   "(index.html) that compares the published numbers with ours. table2: loading; table3: drawing; "
                   "table4: smallest movement and time of a force at five resolutions; fig11: ten-patch object; fig13: "
                   "bur onto a tooth along y; fig15, fig16, fig17: depth, velocity and force on an incisor, a canine "
                   "and a molar. Real teeth come from $TACTOOTH_DATA or ../shared/data, else built-in ones.",
                   options, runReproduce);
    std::vector<std::string> names = experimentNames();
    std::string list = "all";
    for (const std::string& name : names) list.append(", ").append(name);
    names.emplace_back("all");
    command->add_option("WHAT", options->what, "One or more of: " + list)
        ->required()
        ->check(CLI::IsMember(names))
        ->type_name("");
    command->add_option("--out", options->out, "Folder to write to")->required()->type_name("DIR");
}

}  // namespace

void addMeasuringCommands(CLI::App& program, CommandAction& chosen) {
    addBench(program, chosen);
    addRealtime(program, chosen);
    addDevices(program, chosen);
    addReproduce(program, chosen);
}

}  // namespace tactooth

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
#include "experiments/stability.h"

namespace tactooth {
namespace {

/// One tooth to measure on. `form`: what its file holds.
void addLargeTooth(CLI::App& command, std::filesystem::path& file, const std::string& form) {
    command
        .add_option("--tooth", file,
                    form +
                        " (default: a tooth of 325,312 triangles: a real one from $TACTOOTH_DATA or ../shared/data, "
                        "else a built-in one)")
        ->type_name("FILE");
}

void addJson(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Write one JSON object instead of a table");
}

void addRate(CLI::App& command, double& rateHz) {
    command.add_option("--rate", rateHz, "Ticks a second (default: 1000)")
        ->transform(numberFrom(500.0, 4000.0))
        ->type_name("HZ");
}

void addBenchContact(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchContactOptions>();
    CLI::App* command = addCommand(bench, chosen, "contact",
                                   "Time of a tick of contact while a bur comes down on a tooth, is pressed in, slides "
                                   "and leaves, at 1 and 10 cm/s, for several teeth and resolutions.",
                                   options, runBenchContact);
    command
        ->add_option("--tooth", options->tooth,
                     "A closed STL file, mm, crown up (default: front tooth, molar, dog tooth and one of 325,312 "
                     "triangles: real ones from $TACTOOTH_DATA or ../shared/data, else built-in ones)")
        ->type_name("FILE");
    command
        ->add_option("--tool", options->tool,
                     "An STL file, mm: tip at the origin, +z along the shaft (default: a round bur of 336 triangles)")
        ->type_name("FILE");
    command
        ->add_option("--resolution", options->resolutions,
                     "Percent of the tooth's triangles; may be given several times (default: 6, 12, 25, 50 and 100)")
        ->transform(wholeNumberFrom(1, 100))
        ->type_name("PERCENT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        ->add_option("--freedom", options->freedom,
                     "Degrees of freedom of the bur under its contacts: 3 (default) or 6")
        ->check(CLI::IsMember({3, 6}))
        ->type_name("DEGREES");
    command
        ->add_option("--repeat", options->repeat, "Runs of each case, the least time of each tick counts (default: 3)")
        ->transform(wholeNumberFrom(1, 100))
        ->type_name("N");
    addJson(*command, options->json);
}

void addBenchCut(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchCutOptions>();
    CLI::App* command = addCommand(bench, chosen, "cut",
                                   "Time of ticks and of new surfaces while a bur mills slots into a tooth, its whole "
                                   "head deep, for burs of 0.5 to 2.3 mm and voxels of 100 to 15 um.",
                                   options, runBenchCut);
    addLargeTooth(*command, options->tooth, "A closed STL file, mm, crown up");
    command->add_option("--voxel", options->voxels, "Spacing of the cut volume, um; may be given several times")
        ->transform(numberFrom(5.0, 500.0))
        ->type_name("UM")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--diameter", options->diameters, "Of a round bur, mm; may be given several times")
        ->transform(numberFrom(0.3, 5.0))
        ->type_name("MM")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--cores", options->cores, "That the cutter may use (default: 1)")
        ->transform(wholeNumberFrom(1, 256))
        ->type_name("N");
    addJson(*command, options->json);
}

void addBenchSlot(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchSlotOptions>();
    CLI::App* command = addCommand(bench, chosen, "slot",
                                   "Time of a tick, and how steady the force is, while a still bur, and then a probe, "
                                   "rests, trembles, slides and turns in the slot that the bur has just cut.",
                                   options, runBenchSlot);
    addLargeTooth(*command, options->tooth, "A closed STL file, mm, crown up");
    command->add_option("--voxel", options->voxel, "Spacing of the cut volume, um (default: 25)")
        ->transform(numberFrom(5.0, 500.0))
        ->type_name("UM");
    addJson(*command, options->json);
}

void addBenchView(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchViewOptions>();
    CLI::App* command = addCommand(bench, chosen, "view",
                                   "Time of a picture of a large tooth and of a whole mouth with mirror, against the "
                                   "same triangles in one colour, and of a bur that cuts, against one that only moves; "
                                   "needs no display.",
                                   options, runBenchView);
    addLargeTooth(*command, options->tooth, "An STL file, mm");
    command->add_option("--size", options->size, "Pixels (default: 1280x800)")->type_name("WxH");
    command->add_option("--frames", options->frames, "Pictures of each case (default: 60)")
        ->transform(wholeNumberFrom(1, 10000))
        ->type_name("N");
    command->add_flag("--mouth", options->mouth, "The mouth alone: 32 teeth, gums, and a mirror")->excludes("--tooth");
    addJson(*command, options->json);
}

void addBenchStability(CLI::App& bench, CommandAction& chosen) {
    const auto options = std::make_shared<BenchStabilityOptions>();
    CLI::App* command = addCommand(
        bench, chosen, "stability",
        "Whether the force stays steady: simulated devices and hands tap, press, slide, tremble, cut and let go in the "
        "closed loop. "
        "Exit code 1 if a run shakes.",
        options, runBenchStability);
    const auto addNames = [&](const char* name, std::vector<std::string>& into, const char* help,
                              const std::set<std::string>& known) {
        command->add_option(name, into, help)
            ->check(CLI::IsMember(known))
            ->type_name("NAME")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    };
    addNames("--device", options->devices, "omni, touch, touch-x, omega or inverse3; may be given several times",
             {"omni", "touch", "touch-x", "omega", "inverse3"});
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
    command->add_flag("--all", options->all, "A line for each run instead of one for each device and hand");
    addJson(*command, options->json);
}

void addBench(CLI::App& program, CommandAction& chosen) {
    CLI::App* bench = program.add_subcommand("bench", "Measures how long things take on this machine.");
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
                                   "How well this machine keeps time while a simulated hand touches and cuts the "
                                   "built-in molar. Exit code 1 if more than one deadline in a hundred is missed.",
                                   options, runRealtime);
    command->add_option("--seconds", options->seconds, "Length of the run, s (default: 20)")
        ->transform(numberFrom(1.0, 3600.0))
        ->type_name("S");
    addRate(*command, options->rateHz);
    command->add_flag("--load", options->load, "Keep all other cores busy meanwhile");
    addJson(*command, options->json);
}

void addDevices(CLI::App& program, CommandAction& chosen) {
    const auto devices = std::make_shared<DevicesOptions>();
    addCommand(program, chosen, "devices",
               "Which devices are there, and what each can do; why one is not there or not usable, and what to do.",
               devices, runDevices)
        ->add_flag("--json", devices->json, "Write one JSON array instead of lines");
    const auto doctor = std::make_shared<DoctorOptions>();
    addCommand(program, chosen, "doctor",
               "Looks at display, OpenGL, sound, real-time rights and devices, and says what to do about what is "
               "missing. Exit code 1 if the window cannot open.",
               doctor, runDoctor)
        ->add_flag("--json", doctor->json, "Write one JSON array instead of lines");
}

void addReproduce(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ReproduceOptions>();
    CLI::App* command = addCommand(
        program, chosen, "reproduce",
        "Repeats published measurements on this machine and writes tables (CSV), plots (PNG) and one page (index.html) "
        "with the published numbers beside ours. table2: loading; table3: drawing; table4: smallest movement and time "
        "of a force at five resolutions; fig11: ten-patch object; fig13: bur onto a tooth along y; fig15, fig16, "
        "fig17: "
        "depth, velocity and force on a front tooth, a dog tooth and a molar. Real teeth are taken from $TACTOOTH_DATA "
        "or ../shared/data, else built-in ones.",
        options, runReproduce);
    std::vector<std::string> names = experimentNames();
    std::string list = "all";
    for (const std::string& name : names) list.append(", ").append(name);
    names.emplace_back("all");
    command->add_option("WHAT", options->what, "One or several of: " + list)
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

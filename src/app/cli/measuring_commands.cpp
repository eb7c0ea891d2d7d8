// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench_contact_command.h"
#include "app/cli/command_registry.h"

namespace tactooth {
namespace {

void addBench(CLI::App& program, Chosen& chosen) {
    CLI::App* bench = program.add_subcommand("bench", "Measures how long things take on this machine.");
    bench->group("Commands")->footer("")->require_subcommand(1);
    bench->get_formatter()->label("SUBCOMMAND", "WHAT");
    const auto options = std::make_shared<BenchContactOptions>();
    CLI::App* command = addCommand(*bench, chosen, "contact",
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
        ->check(CLI::Range(1, 100))
        ->type_name("PERCENT")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        ->add_option("--repeat", options->repeat, "Runs of each case, the least time of each tick counts (default: 3)")
        ->check(CLI::Range(1, 100))
        ->type_name("N");
    command->add_flag("--json", options->json, "Write one JSON object instead of a table");
}

}  // namespace

void addMeasuringCommands(CLI::App& program, Chosen& chosen) { addBench(program, chosen); }

}  // namespace tactooth

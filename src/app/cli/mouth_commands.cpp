// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bur_command.h"
#include "app/cli/command_registry.h"

namespace tactooth {
namespace {

void addBur(CLI::App& program, Chosen& chosen) {
    const auto options = std::make_shared<BurOptions>();
    CLI::App* command = addCommand(program, chosen, "bur",
                                   "Writes a bur of the catalogue as a closed STL surface: tip at the origin, +z along "
                                   "the shaft, mm.",
                                   options, runBur);
    command->add_option("NUMBER", options->number, "US number (330), shape and size (856-016) or ISO 6360 number")
        ->type_name("");
    command->add_flag("--list", options->list, "List the catalogue: numbers, size, blades or grit");
    command->add_option("--out", options->out, "STL file to write")->type_name("FILE");
    command
        ->add_option("--triangles", options->triangles,
                     "About how many (default: 340, as for contact; from some 5000 on all details show)")
        ->check(CLI::Range(200, 2'000'000))
        ->type_name("N");
}

}  // namespace

void addMouthCommands(CLI::App& program, Chosen& chosen) { addBur(program, chosen); }

}  // namespace tactooth

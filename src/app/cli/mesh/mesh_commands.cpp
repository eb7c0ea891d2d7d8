// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/mesh/simplify_command.h"
#include "app/cli/mesh/subdivide_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/number_range.h"
#include "geometry/mesh/subdivide.h"

namespace tactooth {
namespace {

void addSimplify(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<SimplifyOptions>();
    CLI::App* command = addCommand(
        program, chosen, "simplify",
        "Writes a closed surface with fewer triangles. It stays closed and keeps its topology.", options, runSimplify);
    command->add_option("IN", options->in, "STL file, mm")->required()->type_name("");
    command->add_option("--keep", options->keep, "Share of the triangles to keep (50%), or their number (20000)")
        ->required()
        ->type_name("SHARE");
    command->add_option("--out", options->out, "STL file to write")->required()->type_name("FILE");
}

void addSubdivide(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<SubdivideOptions>();
    CLI::App* command =
        addCommand(program, chosen, "subdivide",
                   "Writes the same surface with more triangles (default: four times as many).", options, runSubdivide);
    command->add_option("IN", options->in, "STL file, mm")->required()->type_name("");
    command->add_option("--out", options->out, "STL file to write")->required()->type_name("FILE");
    CLI::Option* triangles = command->add_option("--triangles", options->triangles,
                                                 "Number of triangles; the longest edges are split first");
    triangles->transform(wholeNumberFrom(1, kMaxSubdivided))->type_name("N");
    command
        ->add_option("--times", options->times, "Number of times that every edge is split: 4^N times as many triangles")
        ->transform(wholeNumberFrom(0, 12))
        ->type_name("N")
        ->excludes(triangles);
}

}  // namespace

void addMeshCommands(CLI::App& program, CommandAction& chosen) {
    addSimplify(program, chosen);
    addSubdivide(program, chosen);
}

}  // namespace tactooth

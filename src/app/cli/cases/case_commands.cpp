// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/case_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/number_range.h"

namespace tactooth {
namespace {

void addScanOptions(CLI::App& command, CaseNewOptions& options) {
    command
        .add_option("--units", options.units,
                    "Unit of the surfaces: mm, cm, inch, m, um, or the number of mm in one unit (default: guessed)")
        ->type_name("UNIT");
    command.add_option("--holes", options.holes, "Holes to fill: small (default), all or none")
        ->check(CLI::IsMember({"small", "all", "none"}))
        ->type_name("WHICH");
    command.add_flag("--upside-down", options.upsideDown, "The crown is at the end opposite to the guess");
    command.add_option("--turn", options.turnDegrees, "Angle to turn the tooth about its long axis, degrees")
        ->transform(numberFrom(-360.0, 360.0))
        ->type_name("DEGREES");
    command.add_flag("--no-model", options.noModel, "Leaves a tooth without layers as one material");
    command
        .add_option("--quadrant", options.quadrant,
                    "Quadrant (FDI: 1 upper right, 2 upper left, 3 lower left, 4 lower right) of teeth whose names end "
                    "in 1 to 8")
        ->transform(wholeNumberFrom(1, 4))
        ->type_name("N");
}

void addNew(CLI::App& parent, CommandAction& chosen) {
    const auto options = std::make_shared<CaseNewOptions>();
    CLI::App* command = addCommand(parent, chosen, "new",
                                   "Makes a case from surfaces (STL, OBJ, PLY) of one or more teeth: repairs them, "
                                   "guesses unit and orientation, and reports what it assumed.",
                                   options, runCaseNew);
    command->add_option("OUT", options->out, "Folder to make, or a file that ends in .ttcase")
        ->required()
        ->type_name("");
    command
        ->add_option("--from", options->from,
                     "Surfaces, or folders with surfaces. L6.stl is the outer surface of tooth L6, L6_enamel.stl its "
                     "enamel; files named *bone, *jaw, *gum or *gingiva are surroundings")
        ->required()
        ->type_name("PATH...");
    addScanOptions(*command, *options);
    command->add_option("--title", options->title, "Name of the case")->type_name("TEXT");
    command->add_option("--licence", options->licence, "Licence of the surfaces")->type_name("TEXT");
    command->add_option("--provenance", options->provenance, "Origin of the surfaces")->type_name("TEXT");
    command->add_option("--bur", options->burs, "Bur of the case: its number, its surface or its TOML description")
        ->type_name("NUMBER|FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--materials", options->materials, "TOML file with the values of materials, as for 'cut'")
        ->type_name("FILE");
}

template <class Options>
void addForOneCase(CLI::App& parent, CommandAction& chosen, const char* name, const char* description,
                   int (*run)(const Options&)) {
    const auto options = std::make_shared<Options>();
    addCommand(parent, chosen, name, description, options, run)
        ->add_option("CASE", options->path, "The case: a folder or a .ttcase file")
        ->required()
        ->type_name("");
}

void addPack(CLI::App& parent, CommandAction& chosen) {
    const auto options = std::make_shared<CasePackOptions>();
    CLI::App* command =
        addCommand(parent, chosen, "pack", "Packs the folder of a case into one .ttcase file.", options, runCasePack);
    command->add_option("FOLDER", options->folder, "Folder with a case.toml")->required()->type_name("");
    command->add_option("--out", options->out, "File to write (default: name of the folder with .ttcase)")
        ->type_name("FILE");
}

}  // namespace

void addCaseCommands(CLI::App& program, CommandAction& chosen) {
    CLI::App* parent = program.add_subcommand(
        "case",
        "Makes, checks, shows or packs a case: teeth with positions, layers, burs and licence in one folder or file.");
    parent->group("Commands")->footer("")->require_subcommand(1);
    addNew(*parent, chosen);
    addForOneCase(*parent, chosen, "check", "Opens a case and reports errors and warnings.", runCaseCheck);
    addForOneCase(*parent, chosen, "info", "Shows the contents of a case and the assumptions made about it.",
                  runCaseInfo);
    addPack(*parent, chosen);
}

}  // namespace tactooth

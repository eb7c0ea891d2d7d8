// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_command.h"
#include "app/cli/cases/calibrate_command.h"
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
    command->add_option("--bur", options->burs, "Bur of the case: its surface or its TOML description")
        ->type_name("FILE")
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

/// What works are compared with.
void addComparison(CLI::App& command, ComparisonOptions& options) {
    CLI::Option* expert =
        command.add_option("--expert", options.expert, "The same of an expert: what is ideal")->type_name("FILE");
    command
        .add_option(
            "--exercise", options.exercise,
            "Exercise that says what is ideal: a TOML file, or a built-in one, as class-1-46 (docs/exercises.md)")
        ->excludes(expert)
        ->type_name("EXERCISE");
    command
        .add_option(
            "--rubric", options.rubric,
            "What the mark is made of: a TOML file (docs/assessment.md), or near-ideal (default, unless the exercise "
            "has another), "
            "near-ideal-strict, class-1, class-3, class-5 or endodontic-access")
        ->type_name("RUBRIC");
    command
        .add_option("--original", options.original,
                    "The uncut tooth (default: that of the exercise, or of the student's file)")
        ->type_name("FILE");
    command.add_flag("--align", options.align, "Lays scans on the uncut tooth first, by what is not prepared");
}

}  // namespace

void addAssessCommand(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<AssessOptions>();
    CLI::App* command =
        addCommand(program, chosen, "assess",
                   "Measures and marks a student's work against an expert's tooth or an exercise, and writes a report.",
                   options, runAssess);
    command
        ->add_option(
            "STUDENT", options->student,
            "The work: a recorded session, a saved tooth, or a surface (STL, OBJ, PLY; mm); or a folder of them: a "
            "report for each, and a table of all")
        ->required()
        ->type_name("");
    addComparison(*command, options->with);
    command->add_option("--name", options->name, "Name of the student, for the report")->type_name("TEXT");
    command->add_option("--comment", options->comment, "The teacher's comment, for the report")->type_name("TEXT");
    command->add_option("--out", options->out, "Folder for report.html, report.pdf, report.json and report.csv")
        ->required()
        ->type_name("DIR");
    command->add_flag("--json", options->json, "Also writes report.json to the standard output");
}

void addCalibrateCommand(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<CalibrateOptions>();
    CLI::App* command = addCommand(program, chosen, "calibrate",
                                   "Fits a rubric to a school's own marks, and says how far the program agrees with "
                                   "its teachers.",
                                   options, runCalibrate);
    command->add_option("WORKS", options->works, "Works as for 'assess', or folders of them")
        ->required()
        ->type_name("");
    command
        ->add_option("--marks", options->marks,
                     "CSV file with the columns work, student, teacher and mark (docs/assessment.md)")
        ->required()
        ->type_name("FILE");
    addComparison(*command, options->with);
    command->add_option("--out", options->out, "File (*.toml) for the fitted rubric")->required()->type_name("FILE");
    command->add_flag("--json", options->json, "Prints the result as JSON");
}

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

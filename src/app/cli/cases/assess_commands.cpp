// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_command.h"
#include "app/cli/cases/calibrate_command.h"
#include "app/cli/cases/learned_command.h"
#include "app/cli/cases/study_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/default_text.h"
#include "app/cli/terminal/number_range.h"
#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

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
        .add_option("--rubric", options.rubric,
                    "What the mark is made of: a TOML file (docs/assessment.md), or one of " + builtinRubricNames() +
                        " (default: that of the exercise, or " + std::string(kUsualRubric) + ")")
        ->type_name("RUBRIC");
    command
        .add_option("--original", options.original,
                    "The uncut tooth (default: that of the exercise, or of the student's file)")
        ->type_name("FILE");
    command.add_flag("--align", options.align, "Lays scans on the uncut tooth first, by what is not prepared");
}

/// The language of pages. `language` outlives the command line.
void addLanguage(CLI::App& command, Language& language) {
    command
        .add_option_function<std::string>(
            "--language",
            [&language](const std::string& name) { language = name == "ja" ? Language::Japanese : Language::English; },
            "Language of pages and PDF (default: en)")
        ->check(CLI::IsMember({"en", "ja"}))
        ->type_name("LANGUAGE");
}

/// A rate of failed trials.
void addRate(CLI::App& command, const std::string& name, double& rate, const std::string& meaning) {
    command.add_option(name, rate, meaning)->transform(numberFrom(0.001, 0.999))->type_name("RATE");
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
            "The work: a recorded session, a saved tooth, or a surface (STL, OBJ, PLY; mm); or a folder of them, "
            "or of a folder for each student: a report for each, and a table of all")
        ->required()
        ->type_name("");
    addComparison(*command, options->with);
    command->add_option("--name", options->name, "Name of the student, for the report")->type_name("TEXT");
    command->add_option("--comment", options->comment, "The teacher's comment, for the report")->type_name("TEXT");
    command
        ->add_option("--earlier", options->earlier,
                     "Folder with reports of earlier trials, at any depth: the report shows how the mark went")
        ->type_name("DIR");
    command->add_option("--out", options->out, "Folder for report.html, report.pdf, report.json and report.csv")
        ->required()
        ->type_name("DIR");
    addLanguage(*command, options->language);
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

void addLearnedCommand(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<LearnedOptions>();
    CLI::App* command = addCommand(program, chosen, "learned",
                                   "Shows from the reports of a student's trials whether an exercise has been learnt.",
                                   options, runLearned);
    command->add_option("REPORTS", options->folder, "Folder with reports of 'assess', at any depth")
        ->required()
        ->type_name("");
    command->add_option("--out", options->out, "Folder for learned.html and learned.json")
        ->required()
        ->type_name("DIR");
    addRate(*command, "--adequate", options->adequate,
            withDefault("Share of trials that who can do it fails", options->adequate));
    addRate(*command, "--inadequate", options->inadequate,
            withDefault("Share of trials that who cannot do it fails", options->inadequate));
    command->add_option("--trials", options->trials, withDefault("Number of trials that are planned", options->trials))
        ->transform(wholeNumberFrom(1, 1000))
        ->type_name("N");
    addRate(*command, "--acceptable", options->acceptable,
            withDefault("Share of failed trials that is acceptable", options->acceptable));
    addRate(*command, "--unacceptable", options->unacceptable,
            withDefault("Share that is not acceptable", options->unacceptable));
    addLanguage(*command, options->language);
    command->add_flag("--json", options->json, "Writes learned.json to the standard output, too");
}

void addStudyCommand(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<StudyOptions>();
    CLI::App* command = addCommand(program, chosen, "study",
                                   "Tests the metrics: synthetic hands with known habits work at an exercise, and each "
                                   "habit must show.",
                                   options, runStudy);
    command
        ->add_option("--exercise", options->exercise,
                     "Exercise at which they work: a TOML file, or a built-in one, as class-1-46 (docs/exercises.md)")
        ->required()
        ->type_name("EXERCISE");
    command
        ->add_option("--rubric", options->rubric,
                     "What the mark is made of, as for 'assess' (default: that of the exercise)")
        ->type_name("RUBRIC");
    command->add_option("--hands", options->hands, withDefault("Number of hands of each level", options->hands))
        ->transform(wholeNumberFrom(2, 100))
        ->type_name("N");
    command->add_option("--seed", options->seed, withDefault("Another number gives other hands", options->seed))
        ->transform(wholeNumberFrom(0, 1000000))
        ->type_name("N");
    command->add_option("--out", options->out, "Folder for study.html, study.csv and study.json")
        ->required()
        ->type_name("DIR");
    command->add_flag("--record", options->record, "Also leaves a recording of each hand, in the folder 'hands'");
    addLanguage(*command, options->language);
    command->add_flag("--json", options->json, "Writes study.json to the standard output, too");
}

}  // namespace tactooth

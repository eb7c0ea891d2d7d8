// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/shapes/bur_command.h"
#include "app/cli/shapes/gallery_command.h"
#include "app/cli/shapes/mouth_command.h"
#include "app/cli/shapes/tooth_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/default_text.h"
#include "app/cli/terminal/number_range.h"

namespace tactooth {
namespace {

// Limits for one tooth, and for each of the 32 teeth that a mouth keeps at once: a gigabyte.
constexpr int kMaxOfTooth = 2'000'000, kMaxOfMouth = 250'000;

CLI::Option* addTriangles(CLI::App& command, int& triangles, const std::string& ofWhat, int most = kMaxOfTooth) {
    return command.add_option("--triangles", triangles, withDefault(ofWhat + ", approximately", triangles))
        ->transform(wholeNumberFrom(1000, most))
        ->type_name("N");
}

void addBur(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<BurOptions>();
    CLI::App* command =
        addCommand(program, chosen, "bur",
                   "Writes a bur of the catalogue as a closed STL surface, mm: tip at the origin, +z along the shaft.",
                   options, runBur);
    command->add_option("NUMBER", options->number, "US number (330), shape and size (856-016) or ISO 6360 number")
        ->type_name("");
    command->add_flag("--list", options->list, "Lists the catalogue: numbers, size, blades or grit");
    command->add_option("--out", options->out, "STL file to write")->type_name("FILE");
    command
        ->add_option("--triangles", options->triangles,
                     withDefault("Number of triangles, made even", options->triangles,
                                 ", as for contact; all details need about 5000"))
        ->transform(wholeNumberFrom(200, 2'000'000))
        ->type_name("N");
}

void addInstrument(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<InstrumentOptions>();
    CLI::App* command =
        addCommand(program, chosen, "instrument", "Writes a handpiece or hand instrument as a closed STL surface, mm.",
                   options, runInstrument);
    command
        ->add_option(
            "NAME", options->name,
            "turbine, contra-angle (electric), low-speed, mirror-22 or mirror-24 (head diameter, mm), explorer "
            "(No. 23), probe (periodontal, mm marks) or excavator (spoon)")
        ->required()
        ->check(CLI::IsMember(
            {"turbine", "contra-angle", "low-speed", "mirror-22", "mirror-24", "explorer", "probe", "excavator"}))
        ->type_name("");
    command->add_option("--out", options->out, "STL file to write")->required()->type_name("FILE");
    command->add_option("--triangles", options->triangles, withDefault("Triangles of a handpiece", options->triangles))
        ->transform(wholeNumberFrom(2000, 24000))
        ->type_name("N");
}

void addTooth(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<ToothOptions>();
    CLI::App* command = addCommand(
        program, chosen, "tooth",
        "Generates a permanent tooth with enamel, dentin and pulp, and writes its layers as closed STL surfaces, mm.",
        options, runTooth);
    command->add_option("FDI", options->fdi, "Tooth number: 11-18, 21-28, 31-38, 41-48")
        ->required()
        ->transform(fdiNumber())
        ->type_name("");
    command->add_option("--out", options->out, "Folder for outer.stl, enamel.stl, dentin.stl, pulp.stl, caries.stl")
        ->required()
        ->type_name("DIR");
    addTriangles(*command, options->triangles, "Triangles of the outer surface");
    command
        ->add_option("--seed", options->seed, withDefault("Seed of the patient", options->seed, ", the average tooth"))
        ->transform(seedNumber())
        ->type_name("N");
    command->add_flag("--no-cache", options->noCache, "Generates the tooth again and does not use the cache");
    CLI::Option* caries = command->add_option(
        "--caries", options->caries, "Surface where decay begins: occlusal, mesial, distal, buccal or lingual");
    caries->check(CLI::IsMember({"occlusal", "mesial", "distal", "buccal", "lingual"}))->type_name("SITE");
    command
        ->add_option("--caries-width", options->cariesWidth,
                     withDefault("Width of the decay in the dentin, mm", options->cariesWidth))
        ->transform(numberFrom(kMinLesionWidth, kMaxLesionWidth))
        ->needs(caries)
        ->type_name("MM");
    command
        ->add_option("--caries-depth", options->cariesDepth,
                     "Depth of the decay below the surface, mm (default: from its width)")
        ->transform(numberFrom(kMinLesionDepth, 6.0))
        ->needs(caries)
        ->type_name("MM");
}

void addWholeMouth(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<MouthOptions>();
    CLI::App* command = addCommand(
        program, chosen, "mouth",
        "Generates all teeth of a mouth on two arches, with layers and gingiva, and writes closed STL surfaces, mm.",
        options, runMouth);
    command->add_option("--out", options->out, "Folder for gingiva-upper.stl, gingiva-lower.stl and 46/outer.stl etc.")
        ->required()
        ->type_name("DIR");
    addMouthSpecOptions(*command, options->mouth, nullptr);
}

void addGallery(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<GalleryOptions>();
    CLI::App* command = addCommand(
        program, chosen, "gallery",
        "Draws the built-in teeth and instruments as contact sheets, teeth.png and instruments.png. Needs no display.",
        options, runGallery);
    command->add_option("--out", options->out, "Folder for the sheets")->required()->type_name("DIR");
    const std::vector<CLI::Option*> ofTeeth = {
        addTriangles(*command, options->triangles, "Triangles of each tooth"),
        command
            ->add_option("--seed", options->seed, withDefault("Seed of the patient", options->seed, ", average teeth"))
            ->transform(seedNumber())
            ->type_name("N"),
        command
            ->add_option("--teeth", options->teeth, "Draws only these teeth (FDI numbers), larger, without instruments")
            ->transform(fdiNumber())
            ->type_name("N"),
        command->add_flag("--no-cache", options->noCache, "Generates all teeth again and does not use the cache")};
    CLI::Option* exercises =
        command->add_flag("--exercises", options->exercises,
                          "Draws the ideal of each built-in exercise instead: ID.jpg. Takes some minutes");
    for (CLI::Option* option : ofTeeth) exercises->excludes(option);
}

}  // namespace

void addMouthSpecOptions(CLI::App& command, MouthSpec& spec, CLI::Option* needed) {
    const std::vector<CLI::Option*> all = {
        addTriangles(command, spec.triangles, "Triangles of each tooth", kMaxOfMouth),
        command.add_option("--seed", spec.seed, withDefault("Seed of the patient", spec.seed, ", average teeth"))
            ->transform(seedNumber())
            ->type_name("N"),
        command.add_option("--jaw", spec.jaw, "open (40 mm between the incisors) or closed (default)")
            ->check(CLI::IsMember({"open", "closed"}))
            ->type_name("POSE"),
        command.add_option("--missing", spec.missing, "Missing teeth, for example 18,28,46; their sites have healed")
            ->delimiter(',')
            ->transform(fdiNumber())
            ->type_name("FDI"),
        command.add_flag("--no-cache", spec.noCache, "Generates all teeth and gums again and does not use the cache")};
    if (needed == nullptr) return;
    for (CLI::Option* option : all) option->needs(needed);
}

void addMouthCommands(CLI::App& program, CommandAction& chosen) {
    addBur(program, chosen);
    addInstrument(program, chosen);
    addTooth(program, chosen);
    addWholeMouth(program, chosen);
    addGallery(program, chosen);
}

}  // namespace tactooth

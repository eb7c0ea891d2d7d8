// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bur_command.h"
#include "app/cli/command_registry.h"
#include "app/cli/gallery_command.h"
#include "app/cli/tooth_command.h"

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

void addInstrument(CLI::App& program, Chosen& chosen) {
    const auto options = std::make_shared<InstrumentOptions>();
    CLI::App* command =
        addCommand(program, chosen, "instrument", "Writes a handpiece or hand instrument as a closed STL surface, mm.",
                   options, runInstrument);
    command
        ->add_option("NAME", options->name,
                     "turbine, mirror-22, mirror-24 (head, mm), explorer (No. 23) or probe (periodontal, mm marks)")
        ->required()
        ->check(CLI::IsMember({"turbine", "mirror-22", "mirror-24", "explorer", "probe"}))
        ->type_name("");
    command->add_option("--out", options->out, "STL file to write")->required()->type_name("FILE");
    command->add_option("--triangles", options->triangles, "Of the turbine (default: 16000)")
        ->check(CLI::Range(2000, 24000))
        ->type_name("N");
}

void addTooth(CLI::App& program, Chosen& chosen) {
    const auto options = std::make_shared<ToothOptions>();
    CLI::App* command = addCommand(program, chosen, "tooth",
                                   "Makes a permanent tooth with enamel, dentin and pulp and writes its layers as "
                                   "closed STL surfaces, mm.",
                                   options, runTooth);
    command->add_option("FDI", options->fdi, "Tooth number: 11-18, 21-28, 31-38, 41-48")->required()->type_name("");
    command->add_option("--out", options->out, "Folder for outer.stl, enamel.stl, dentin.stl, pulp.stl, caries.stl")
        ->required()
        ->type_name("DIR");
    command->add_option("--triangles", options->triangles, "Of the outer surface, about (default: 20000)")
        ->check(CLI::Range(1000, 2'000'000))
        ->type_name("N");
    command->add_option("--seed", options->seed, "Another patient for each number (default: 0, the average tooth)")
        ->type_name("N");
    CLI::Option* caries = command->add_option("--caries", options->caries,
                                              "Decay that begins there: occlusal, mesial, distal, buccal, lingual");
    caries->check(CLI::IsMember({"occlusal", "mesial", "distal", "buccal", "lingual"}))->type_name("SITE");
    command->add_option("--caries-width", options->cariesWidth, "Where it spreads in the dentin, mm (default: 2.4)")
        ->check(CLI::Range(0.4, 4.0))
        ->needs(caries)
        ->type_name("MM");
    command
        ->add_option("--caries-depth", options->cariesDepth, "Below the surface, mm (default: as its width suggests)")
        ->check(CLI::Range(0.3, 6.0))
        ->needs(caries)
        ->type_name("MM");
}

void addGallery(CLI::App& program, Chosen& chosen) {
    const auto options = std::make_shared<GalleryOptions>();
    CLI::App* command = addCommand(program, chosen, "gallery",
                                   "Draws the built-in teeth and instruments as contact sheets, teeth.png and "
                                   "instruments.png; needs no display.",
                                   options, runGallery);
    command->add_option("--out", options->out, "Folder for the sheets")->required()->type_name("DIR");
    command->add_option("--triangles", options->triangles, "Of each tooth, about (default: 20000)")
        ->check(CLI::Range(1000, 2'000'000))
        ->type_name("N");
    command->add_option("--seed", options->seed, "The teeth of another patient (default: 0, average teeth)")
        ->type_name("N");
    command->add_option("--teeth", options->teeth, "Only these teeth (FDI numbers), larger, and no instruments")
        ->type_name("N");
}

}  // namespace

void addMouthCommands(CLI::App& program, Chosen& chosen) {
    addBur(program, chosen);
    addInstrument(program, chosen);
    addTooth(program, chosen);
    addGallery(program, chosen);
}

}  // namespace tactooth

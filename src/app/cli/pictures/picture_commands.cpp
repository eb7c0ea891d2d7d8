// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pictures/render_command.h"
#include "app/cli/terminal/command_registry.h"
#include "app/cli/terminal/default_text.h"
#include "app/cli/terminal/number_range.h"
#include "app/common/inspection.h"
#include "instruments/mirror.h"

namespace tactooth {
namespace {

void addSubject(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--tooth,--case,TOOTH", options.tooth,
                    "STL file (mm, crown toward +z), a case or a saved tooth (default: the built-in molar)")
        ->type_name("FILE");
    command.add_option("--work-on", options.workOn, "Tooth of the case to show (default: all teeth)")
        ->type_name("NAME")
        ->needs("--tooth");
    command.add_option("--layer", options.layers, "Layer inside --tooth, as for 'cut'")
        ->type_name("NAME=FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->needs("--tooth");
    command
        .add_option("--materials", options.materials,
                    "TOML file that changes the colours of materials (example: data/materials.toml)")
        ->type_name("FILE");
    command
        .add_option("--mirror", options.mirror,
                    "Adds a mouth mirror with a head of this diameter, mm: 18 (No. 2) to 26 (No. 6)")
        ->transform(numberFrom(kSmallestMirror, kLargestMirror))
        ->type_name("MM");
    command.add_option("--fog", options.fog, "Fog on the mirror")->transform(numberFrom(0.0, 1.0))->type_name("SHARE");
    command.add_option("--drops", options.drops, "Share of the mirror covered by drops")
        ->transform(numberFrom(0.0, 1.0))
        ->type_name("SHARE");
}

void addMouth(CLI::App& command, RenderOptions& options) {
    CLI::Option* mouth = command.add_flag("--mouth", options.mouth,
                                          "Shows the whole built-in mouth; then --view is front, right, left, upper, "
                                          "lower, dentist, or AZIMUTH,ELEVATION (90,0: from the front)");
    addMouthSpecOptions(command, options.mouthSpec, mouth);
    command
        .add_flag("--soft-tissues", options.softTissues, "Adds cheeks, lips and tongue of an open mouth (--jaw open)")
        ->needs(mouth);
    for (const char* other : {"--tooth", "--layer", "--materials", "--mirror", "--clip", "--transparent", "--target",
                              "--stereo", "--second", "--marks"}) {
        mouth->excludes(other);
    }
}

std::vector<std::string> standardViewNames() {
    std::vector<std::string> names;
    for (const auto& [name, view] : kStandardViews) names.emplace_back(name);
    return names;
}

void addEye(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--view", options.view,
                    "occlusal, buccal, lingual, mesial, distal, dentist (default), or AZIMUTH,ELEVATION in degrees "
                    "(0,0: from mesial; 90,0: from buccal; elevation 90: from occlusal)")
        ->type_name("VIEW");
    command.add_option("--at", options.at, "Centre of the picture in the tooth frame, mm")->type_name("X,Y,Z");
    command.add_option("--span", options.span, "Height of the picture, mm (default: the whole tooth)")
        ->transform(numberFrom(0.2, 1000.0))
        ->type_name("MM");
    command
        .add_option("--turntable", options.turntable,
                    "Number of pictures of a full turn: X-000.png, X-001.png and so on")
        ->transform(wholeNumberFrom(2, 3600))
        ->type_name("N");
    CLI::Option* stereo = command
                              .add_option("--stereo", options.stereo,
                                          "Stereo picture: side-by-side, or anaglyph for red and cyan glasses")
                              ->check(CLI::IsMember({"side-by-side", "anaglyph"}))
                              ->type_name("MODE");
    command
        .add_option("--second", options.second,
                    "Adds a small second view in the corner: occlusal, buccal, lingual, mesial or distal")
        ->check(CLI::IsMember(standardViewNames()))
        ->excludes(stereo)
        ->type_name("VIEW");
    command
        .add_flag("--marks", options.marks,
                  "Adds a scale bar (at the depth of the centre) and letters of the directions: B buccal, L lingual, "
                  "M mesial, D distal, O occlusal, A apical")
        ->excludes(stereo);
}

void addInspection(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--clip", options.clip,
                    "Removes what lies on this side (occlusal, buccal, lingual, mesial, distal) of the centre of the "
                    "tooth, or of a plane so many mm from it")
        ->type_name("SIDE[=MM]");
    command
        .add_option("--transparent", options.transparent, "Opacity of a tissue, 0 to 1 (enamel=0.3); may be repeated")
        ->type_name("NAME=OPACITY")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--target", options.target,
                    "Closed STL file of the ideal shape: colours the tooth by its distance to it (orange: too much was "
                    "cut; blue: too little)")
        ->type_name("FILE");
    command
        .add_flag("--ghost", options.ghost,
                  "Shows the cavity that is still to be cut as blue glass, instead of the colours")
        ->needs("--target");
    command.add_option("--range", options.range, withDefault("Distance with the strongest colour, mm", options.range))
        ->transform(numberFrom(0.001, 100.0))
        ->type_name("MM");
    command
        .add_option("--tolerance", options.tolerance,
                    withDefault("Smaller distances are white, and an edge shows where they end, mm", options.tolerance,
                                ": no edge"))
        ->transform(numberFrom(0.0, 100.0))
        ->type_name("MM")
        ->needs("--target");
}

}  // namespace

void addPictureCommands(CLI::App& program, CommandAction& chosen) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* command = addCommand(
        program, chosen, "render",
        "Draws a tooth into one picture (PNG) or the pictures of a full turn. Needs no display and no graphics card.",
        options, runRender);
    addSubject(*command, *options);
    addEye(*command, *options);
    addInspection(*command, *options);
    addMouth(*command, *options);
    command->add_option("--size", options->size, withDefault("Size in pixels", options->size, "; at most 4096x4096"))
        ->type_name("WxH");
    command->add_flag("--no-background", options->noBackground, "Leaves the background transparent");
    command->add_option("--out", options->out, "PNG file to write")->required()->type_name("FILE");
}

}  // namespace tactooth

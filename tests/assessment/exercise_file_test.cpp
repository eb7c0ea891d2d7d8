// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/exercise_file.h"

#include <gmock/gmock.h>

#include "assessment/allowed_instruments.h"
#include "assessment/exercise_keys.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/bur_catalogue.h"
#include "session/io/material_file.h"
#include "support/shapes.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

/// A complete exercise on the built-in molar, with `change` in the place of `line`.
std::string exerciseWith(std::string_view line = {}, std::string_view change = {}) {
    std::string text =
        "name = \"Pit\"\n"
        "task = \"Drill.\"\n"
        "tooth = 36\n"
        "bur = \"330\"\n"
        "[cavity]\n"
        "depth = 1.5\n"
        "[[cavity.strokes]]\n"
        "from = [0.5, 0, 0]\n";
    if (!line.empty()) text.replace(text.find(line), line.size(), change);
    return text;
}

const std::string kStroke = "[[cavity.strokes]]\nfrom = [0.5, 0, 0]\n";
const std::string kFissure = "[cavity.fissure]\nwidth = 1\n";
const std::string kCaries = "[cavity.removes]\ntissue = \"caries\"\n";
const std::string kBox = "[[cavity.boxes]]\nside = \"mesial\"\nwidth = 3\naxial_depth = 1.3\naxial_height = 1.1\n";

Expected<Exercise> parsed(const std::string& text) { return parseExercise(text, "pit.toml", "/somewhere"); }

TEST(ExerciseFile, DescribesABuiltInToothABurAndWhatItCuts) {
    const auto exercise =
        parsed(exerciseWith("tooth = 36", "tooth = 36\npatient = 7\ndecay = {site = \"occlusal\", width = 1.5}"));
    ASSERT_TRUE(exercise) << exercise.error().message();
    EXPECT_EQ(exercise->name, "Pit");
    EXPECT_EQ(exercise->task, "Drill.");
    const auto& tooth = std::get<ToothRequest>(exercise->tooth);
    EXPECT_EQ(tooth.fdi, 36);
    EXPECT_EQ(tooth.seed, 7U);
    EXPECT_EQ(tooth.lesion->site, LesionSite::Occlusal);
    EXPECT_EQ(tooth.lesion->width, 1.5);
    EXPECT_EQ(std::get<std::string>(exercise->bur), "330");
    const auto& plan = std::get<PreparationPlan>(exercise->ideal);
    EXPECT_EQ(plan.outward, Vec3::UnitZ());
    EXPECT_EQ(plan.depth, 1.5);
    EXPECT_TRUE(plan.isFlat);
    ASSERT_EQ(plan.strokes.size(), 1U);
    EXPECT_EQ(plan.strokes[0].from, Vec3(0.5, 0, 0));
    EXPECT_EQ(plan.strokes[0].to, Vec3(0.5, 0, 0));
}

TEST(ExerciseFile, ADeviceStopsAtTheDepthOnlyIfItIsSaidSo) {
    const auto stops = [](const std::string& key) {
        const auto exercise = parsed(exerciseWith("depth = 1.5", "depth = 1.5\n" + key));
        EXPECT_TRUE(exercise) << exercise.error().message();
        return std::get<PreparationPlan>(exercise->ideal).stopsDevice;
    };
    EXPECT_FALSE(stops(""));
    EXPECT_FALSE(stops("depth_stop = false"));
    EXPECT_TRUE(stops("depth_stop = true"));
    EXPECT_FALSE(parsed(exerciseWith("depth = 1.5", "depth = 1.5\ndepth_stop = 1")));
}

TEST(ExerciseFile, NamesFilesBesideIt) {
    const auto exercise = parsed(
        "name = \"Own\"\ntask = \"Cut.\"\ntooth = \"teeth/own.stl\"\nlayers = {dentin = \"dentin.stl\"}\n"
        "bur = \"bur.stl\"\nideal = \"ideal.stl\"\n");
    ASSERT_TRUE(exercise) << exercise.error().message();
    const auto& source = std::get<ToothSource>(exercise->tooth);
    EXPECT_EQ(source.outer, "/somewhere/teeth/own.stl");
    ASSERT_EQ(source.layers.size(), 1U);
    EXPECT_EQ(source.layers[0].material, "dentin");
    EXPECT_EQ(source.layers[0].file, "/somewhere/dentin.stl");
    EXPECT_EQ(std::get<std::filesystem::path>(exercise->bur), "/somewhere/bur.stl");
    EXPECT_EQ(std::get<std::filesystem::path>(exercise->ideal), "/somewhere/ideal.stl");
}

TEST(ExerciseFile, KnowsWhereMesialIs) {
    const auto side = [](const char* tooth, const char* name) {
        std::string text = exerciseWith("tooth = 36", tooth);
        text.replace(text.find("depth"), 0, std::string("side = ") + name + "\n");
        return std::get<PreparationPlan>(parsed(text).value().ideal).outward;
    };
    EXPECT_EQ(side("tooth = 36", "\"mesial\""), Vec3::UnitX());
    EXPECT_EQ(side("tooth = 46", "\"mesial\""), -Vec3::UnitX());
    EXPECT_EQ(side("tooth = 46", "\"distal\""), Vec3::UnitX());
    EXPECT_EQ(side("tooth = 46", "\"lingual\""), -Vec3::UnitY());
    EXPECT_EQ(side("tooth = 46", "[0, 3, 0]"), Vec3::UnitY());
}

TEST(ExerciseFile, SaysWhatListsAndMarksNeed) {
    const auto exercise = parsed(exerciseWith(
        "tooth = 36",
        "brief = \"Lightly.\"\njapanese = {name = \"穴\", task = \"削る。\"}\ngroup = \"class-1\"\nlevel = \"hard\"\n"
        "minutes = 7\ntolerance = 0.2\nrubric = \"class-1\"\ntooth = 36\nmouth = true\nother_burs = [\"245\"]"));
    ASSERT_TRUE(exercise) << exercise.error().message();
    EXPECT_EQ(exercise->words(Language::English).brief, "Lightly.");
    EXPECT_EQ(exercise->words(Language::Japanese).name, "穴");
    EXPECT_EQ(exercise->group, ExerciseGroup::ClassOne);
    EXPECT_EQ(exercise->level, ExerciseLevel::Hard);
    EXPECT_EQ(exercise->minutes, 7);
    EXPECT_EQ(exercise->tolerance, 0.2);
    EXPECT_EQ(exercise->rubric, "class-1");
    EXPECT_TRUE(exercise->inMouth);
    EXPECT_THAT(exercise->otherBurs, ::testing::ElementsAre("245"));
    EXPECT_EQ(parsed(exerciseWith()).value().words(Language::Japanese).name, "Pit");  // it has no other words
    EXPECT_EQ(parsed(exerciseWith()).value().group, ExerciseGroup::Own);
}

TEST(ExerciseFile, EndsAFissureWithARidgeOrABox) {
    const auto exercise = parsed(exerciseWith(kStroke, kFissure + "distal = 2\n" + kBox));
    ASSERT_TRUE(exercise) << exercise.error().message();
    const auto& plan = std::get<PreparationPlan>(exercise->ideal);
    EXPECT_EQ(plan.fissure->width, 1);
    EXPECT_EQ(plan.fissure->burRadius, 0.4);
    EXPECT_EQ(plan.fissure->leftMinusX, 2);  // mesial is at +x on 36
    EXPECT_FALSE(plan.fissure->leftPlusX);
    ASSERT_EQ(plan.boxes.size(), 1U);
    EXPECT_EQ(plan.boxes[0].towardX, 1);
    EXPECT_EQ(plan.boxes[0].axialHeight, 1.1);
}

const std::string kCrown = "[cavity.crown]\nfinish = \"shoulder\"\nwidth = 1\nheight = 1\ntaper = 6\n";
const std::string kOutline = "[cavity.outline]\ntaper = 4\ncorners = [[-2, -1, 6], [3, -1, 6], [3, 1, 6]]\n";

TEST(ExerciseFile, HasAnOutlineThatSomebodyHasDrawn) {
    const auto exercise = parsed(exerciseWith(kStroke, kOutline + kBox));
    ASSERT_TRUE(exercise) << exercise.error().message();
    const auto& plan = std::get<PreparationPlan>(exercise->ideal);
    ASSERT_TRUE(plan.outline);
    EXPECT_EQ(plan.outline->corners[1], Vec3(3, -1, 6));
    EXPECT_EQ(plan.outline->taperDegrees, 4);
    EXPECT_EQ(plan.outline->burRadius, 0.4);
    EXPECT_EQ(plan.outline->burLength, 1.6);
    EXPECT_EQ(plan.boxes.size(), 1U);
}

TEST(ExerciseFile, NamesPlacesOfDecayAndWhereNothingMayBeCut) {
    const auto exercise = parsed(exerciseWith("tooth = 36", "tooth = 36\ndecay = {at = [1, 2, 6.5], width = 2}") +
                                 "[[forbidden]]\nside = \"mesial\"\ncorners = [[3, 0, 1], [3, 1, 1], [3, 1, 2]]\n");
    ASSERT_TRUE(exercise) << exercise.error().message();
    EXPECT_EQ(std::get<ToothRequest>(exercise->tooth).lesion->place, Vec3(1, 2, 6.5));
    ASSERT_EQ(exercise->forbidden.size(), 1U);
    EXPECT_EQ(exercise->forbidden[0].outward, Vec3::UnitX());
    EXPECT_EQ(exercise->forbidden[0].corners[2], Vec3(3, 1, 2));
}

TEST(ExerciseFile, AllowsEachInstrumentUnlessItNamesSome) {
    const auto exercise = parsed(exerciseWith());
    ASSERT_TRUE(exercise) << exercise.error().message();
    for (const BurSpec& bur : burCatalogue()) EXPECT_TRUE(allowsBur(*exercise, bur.number));
    EXPECT_TRUE(allowsBurFile(*exercise, "/somewhere/own.stl"));
    for (const auto& [key, instrument] : kInstrumentKeys) EXPECT_TRUE(allows(*exercise, instrument)) << key;
    EXPECT_EQ(instrumentNames(*exercise), "");
}

TEST(ExerciseFile, AllowsOnlyTheInstrumentsThatItNames) {
    const auto exercise =
        parsed(exerciseWith("bur = \"330\"",
                            "bur = \"330\"\nother_burs = [\"4\"]\nonly_these_burs = true\n"
                            "instruments = [\"excavator\", \"low-speed\", \"turbine\", \"turbine\"]"));
    ASSERT_TRUE(exercise) << exercise.error().message();
    for (const BurSpec& bur : burCatalogue())
        EXPECT_EQ(allowsBur(*exercise, bur.number), bur.number == "330" || bur.number == "4") << bur.number;
    EXPECT_FALSE(allowsBurFile(*exercise, "/somewhere/own.stl"));
    EXPECT_EQ(instrumentNames(*exercise), "turbine, low-speed, excavator");
    EXPECT_TRUE(allows(*exercise, HandpieceKind::LowSpeed));
    EXPECT_TRUE(allows(*exercise, HandInstrument::Excavator));
    EXPECT_FALSE(allows(*exercise, HandpieceKind::ContraAngle));
    EXPECT_FALSE(allows(*exercise, HandInstrument::Explorer));
    EXPECT_FALSE(allows(*exercise, HandInstrument::Probe));
}

TEST(ExerciseFile, AllowsItsOwnBurFromAFile) {
    const auto exercise =
        parsed(exerciseWith("bur = \"330\"", "bur = \"own.stl\"\nother_burs = [\"4\"]\nonly_these_burs = true"));
    ASSERT_TRUE(exercise) << exercise.error().message();
    EXPECT_TRUE(allowsBurFile(*exercise, "/somewhere/own.stl"));
    EXPECT_FALSE(allowsBurFile(*exercise, "/somewhere/other.stl"));
    EXPECT_TRUE(allowsBur(*exercise, "4"));
    EXPECT_FALSE(allowsBur(*exercise, "330"));
}

TEST(ExerciseFile, ACavityIsOpenToASideOfTheTooth) {
    const auto openTo = [](const std::string& key) {
        const auto exercise = parsed(exerciseWith(kStroke, kCaries + key));
        EXPECT_TRUE(exercise) << exercise.error().message();
        return std::get<PreparationPlan>(exercise->ideal).body->openTo;
    };
    EXPECT_FALSE(openTo(""));
    EXPECT_EQ(openTo("open = \"mesial\"\n"), Vec3(mesialX(36) * Vec3::UnitX()));
    EXPECT_EQ(openTo("open = \"distal\"\n"), Vec3(-mesialX(36) * Vec3::UnitX()));
    EXPECT_EQ(openTo("open = \"buccal\"\n"), Vec3(Vec3::UnitY()));
}

TEST(ExerciseFile, ASoundToothHasNoDecayToRemove) {
    const auto exercise = parsed(exerciseWith(kStroke, "[cavity.removes]\ntissue = \"caries\"\n"));
    ASSERT_TRUE(exercise) << exercise.error().message();
    const auto ideal = idealShape(*exercise, *exerciseTooth(*exercise));
    ASSERT_FALSE(ideal);
    EXPECT_THAT(ideal.error().message(),
                HasSubstr("the tooth has no caries, filling or pulp that is wider than the bur"));
}

TEST(ExerciseFile, IsRefusedWithASentenceThatNamesTheLine) {
    const std::vector<std::array<std::string, 3>> mistakes = {
        {"name = \"Pit\"\n", "", "the key 'name' is missing"},
        {"tooth = 36", "tooth = 39", "line 3: 39 is no permanent tooth"},
        {"tooth = 36", "tooth = \"../own.stl\"", "line 3: '../own.stl' must lie beside this file"},
        {"tooth = 36", "tooth = 36\ndecay = {site = \"top\"}", "'site' must be"},
        {"tooth = 36", "tooth = 36\ndecay = {width = 0}", "'width' must be"},
        {"tooth = 36", "tooth = 36\ndecay = {depth = 0}", "'depth' must be"},
        {"tooth = 36", "tooth = 11\ndecay = {site = \"occlusal\"}", "an anterior tooth has no occlusal side"},
        {"tooth = 36", "tooth = \"a.stl\"\npatient = 3", "'patient' belongs to a built-in tooth"},
        {"tooth = 36", "tooth = 36\nlayers = {dentin = \"d.stl\"}", "a built-in tooth brings its own layers"},
        {"tooth = 36", "tooth = \"a.stl\"\nlayers = {gold = \"d.stl\"}", "there is no material 'gold'"},
        {"tooth = 36", "teeth = 36", "an exercise has no key 'teeth'"},
        {"bur = \"330\"", "bur = \"999\"", "line 4: there is no bur '999'"},
        {"bur = \"330\"", "bur = 330", "line 4: 'bur' must be a text"},
        {"[cavity]", "ideal = \"i.stl\"\n[cavity]", "give the ideal shape either"},
        {kStroke, "[cavity.outline]\ncorners = [[0, 0, 0], [1, 0, 0]]\n", "line 8: 'corners' must be a list of 3 to"},
        {kStroke, "[cavity.outline]\ncorners = [[0, 0, 0], [1, 0, 0], [1, 1]]\n", "line 8: 'corners' must be a list"},
        {kStroke, "[cavity.outline]\ncorners = [[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]\n", "crosses itself"},
        {kStroke, "[cavity.outline]\n", "'corners' must be a list"},
        {kStroke, "[cavity.outline]\ncorners = [[-400, 0, 5], [400, 0, 5], [0, 400, 5]]\n", "larger than any tooth"},
        {kStroke, "[cavity.outline]\ncorners = [[0, 0, 5], [51, 0, 5], [0, 3, 5]]\n", "larger than any tooth"},
        {kStroke, "[cavity.outline]\ncorners = [[0, 0, 5], [3, 0, 5], [0, 3, 5]]\n[cavity.crown]\n",
         "a crown preparation takes the place"},
        {kStroke, "[cavity.removes]\ntissue = \"caries\"\n[cavity.crown]\n", "a crown preparation takes the place"},
        {kStroke, kFissure + "mesial = 2\ndistal = 2\n[cavity.crown]\n", "a crown preparation takes the place"},
        {kStroke, kCrown + "incisal = 2\nfunctional = 1\n",
         "a tooth with an edge has no functional cusps: remove 'functional'"},
        {kStroke, kCrown + "incisal = 2\nocclusal = 1\n", "give either 'occlusal'"},
        {kStroke, kCrown + "incisal = 2\nrounding = 0.6\n", "'rounding' must be a number from 0 to 0.5"},
        {kStroke, kCrown + "incisal = 2\nbuccal = 0\n", "'buccal' must be a number from 0.05 to 3"},
        {kStroke, kCrown + "incisal = 2\nlingual = 4\n", "'lingual' must be a number from 0.05 to 3"},
        {kStroke, kCrown + "incisal = 2\nbuccal_taper = 0\n", "'buccal_taper' must be a number from 1 to 30"},
        {kStroke, kCrown + "incisal = 2\nmesial_height = 9\n", "'mesial_height' must be a number from -1 to 8"},
        {"tooth = 36", "tooth = 36\nfilling = {width = 1.6, depth = 1.8, material = \"gold\"}",
         "'gold' is no material of a filling; give one of these: restoration"},
        {"[cavity]", "[materials.Gold]\n[cavity]", "'Gold'"},
        {"[cavity]", "[materials.gold]\nstiffness = 9\n[cavity]", "'stiffness' must be a number from 0 to 5"},
        {"[cavity]", "[materials.gold]\nweight = 9\n[cavity]", "'weight'"},
        {"[cavity]", "[materials]\ngold = 3\n[cavity]", "gold"},
        {kStroke, kStroke + kOutline, "an outline takes the place of strokes"},
        {"[cavity]\ndepth = 1.5\n" + kStroke, "[cavity]\ndepth = 1.5\nside = \"buccal\"\n" + kOutline + kBox,
         "a box needs a cavity from the occlusal side"},
        {"tooth = 36", "tooth = 36\ndecay = {site = \"buccal\", at = [0, 0, 0]}", "either a 'site' or a place"},
        {"tooth = 36", "tooth = 36\ndecay = {at = [0, 0, 9000]}", "far away from any tooth"},
        {"tooth = 36", "tooth = 36\ndecay = {site = \"buccal\", spread = [[0, 0, 5]]}", "begins at a place, 'at'"},
        {"tooth = 36", "tooth = 36\ndecay = {at = [0, 0, 5], spread = []}", "'spread' must be a list of 1 to 60"},
        {"tooth = 36", "tooth = 36\ndecay = {at = [0, 0, 5], spread = [[0, 0, 501]]}", "'spread' must be a list of"},
        {"tooth = 36", "tooth = 36\ndecay = {at = [0, 0, 5], spread = [[0, 0, nan]]}", "'spread' must be a list of"},
        {"tooth = 36", "tooth = 36\ndecay = {rim = {width = 0.5, material = \"stone\"}}",
         "'stone' is no material of a rim; give one of these: restoration"},
        {"tooth = 36", "tooth = 36\ndecay = {rim = {material = \"restoration\"}}",
         "the material 'restoration' of a rim needs a 'nesting' from 1 (dentin) to below 2 (pulp)"},
        {"tooth = 36", "tooth = 36\ndecay = {rim = {width = 9, material = \"restoration\"}}",
         "'width' must be a number from 0.1 to 2"},
        {"[cavity]", "[[forbidden]]\nside = \"mesial\"\n[cavity]", "'corners' must be a list"},
        {"depth = 1.5", "depth = 0", "line 6: 'depth' must be a number from 0.05 to 15"},
        {"depth = 1.5\n", "", "the key 'depth' is missing"},
        {"depth = 1.5", "depth = 1.5\nside = \"above\"", "'side' must be"},
        {"depth = 1.5", "depth = 1.5\nside = [0, 0, 0]", "'side' has no direction"},
        {"depth = 1.5", "depth = 1.5\nfloor = \"round\"", "'floor' must be flat"},
        {"[[cavity.strokes]]\nfrom = [0.5, 0, 0]\n", "", "there are no strokes"},
        {"from = [0.5, 0, 0]", "to = [0.5, 0, 0]", "the key 'from' is missing"},
        {"from = [0.5, 0, 0]", "from = [0.5, 0]", "line 8: 'from' must be a list of 3 numbers"},
        {"from = [0.5, 0, 0]", "from = [0.5, 0, 0]\nto = [0, 90, 0]", "longer or farther away than any tooth"},
        {"tooth = 36", "group = \"class-9\"\ntooth = 36", "'group' must be"},
        {"tooth = 36", "level = \"simple\"\ntooth = 36", "'level' must be"},
        {"tooth = 36", "minutes = 0\ntooth = 36", "'minutes' must be"},
        {"tooth = 36", "tolerance = 9\ntooth = 36", "'tolerance' must be"},
        {"tooth = 36", "rubric = \"nine\"\ntooth = 36", "there is no built-in rubric 'nine'"},
        {"tooth = 36", "japanese = {name = \"a\"}\ntooth = 36", "the key 'task' is missing"},
        {"tooth = 36", "tooth = 36\nmouth = true\npatient = 3", "the whole mouth has average teeth"},
        {"tooth = 36", "tooth = \"a.stl\"\nmouth = true", "'mouth' belongs to a built-in tooth"},
        {"tooth = 36", "other_burs = [\"999\"]\ntooth = 36", "there is no bur '999'"},
        {"from = [0.5, 0, 0]", "from = [0.5, 0, 0]\ndepth = 99", "line 9: 'depth' must be"},
        {kStroke, kFissure + "mesial = 2\n", "each end of a fissure has either a box or 'distal'"},
        {kStroke, kFissure + "mesial = 2\ndistal = 2\n" + kBox, "each end of a fissure has either a box or 'mesial'"},
        {kStroke, kFissure + "distal = 2\n" + kBox + kBox, "there is already a box on this side"},
        {kStroke, kFissure + "mesial = 2\ndistal = 2\n" + kStroke, "a fissure takes the place of the strokes"},
        {kStroke, kBox, "a box ends a cavity along a fissure"},
        {kStroke, "[cavity.removes]\ntissue = \"bone\"\n", "'tissue' must be caries, pulp or filling"},
        {kStroke, "[cavity.removes]\ntissue = \"pulp\"\n", "the key 'below' is missing"},
        {"tooth = 36", "tooth = 36\nonly_these_burs = 1", "line 4: 'only_these_burs' must be true or false"},
        {"tooth = 36", "tooth = 36\ninstruments = \"turbine\"", "line 4: 'instruments'"},
        {"tooth = 36", "tooth = 36\ninstruments = [1]", "line 4: 'instruments'"},
        {"tooth = 36", "tooth = 36\ninstruments = [\"turbine\", \"laser\"]", "line 4: 'instruments' knows no 'laser'"},
        {"tooth = 36", "tooth = 36\ninstruments = []", "line 4: 'instruments' must name at least one handpiece"},
        {"tooth = 36", "tooth = 36\ninstruments = [\"probe\"]",
         "line 4: 'instruments' must name at least one handpiece"},
        {kStroke, kCaries + "open = \"front\"\n", "line 9: 'open' must be occlusal, buccal, lingual, mesial or distal"},
        {kStroke, kCaries + "open = 3\n", "'open' must be a text"},
        {kStroke, kCaries + "open = \"occlusal\"\n", "'open' must name another side than that from which the bur"},
        {kStroke, "[cavity.removes]\ntissue = \"pulp\"\nbelow = 1\nopen = \"mesial\"\n", "is not for the pulp"},
        {kStroke, "[cavity.removes]\ntissue = \"caries\"\n" + kStroke, "'removes' takes the place of the strokes"},
        {"name = \"Pit\"", "name = ", "line 1: this is not TOML"}};
    for (const auto& [line, change, words] : mistakes) {
        const auto exercise = parsed(exerciseWith(line, change));
        ASSERT_FALSE(exercise) << words;
        EXPECT_THAT(exercise.error().message(), HasSubstr(words));
        EXPECT_THAT(exercise.error().message(), HasSubstr("pit.toml, line "));
    }
}

TEST(ExerciseFile, AStrokeBesideTheToothIsRefused) {
    const auto exercise = parsed(exerciseWith("from = [0.5, 0, 0]", "from = [0.5, 0, 0]\nto = [30, 0, 0]"));
    ASSERT_TRUE(exercise);
    const auto ideal = idealShape(*exercise, *exerciseTooth(*exercise));
    ASSERT_FALSE(ideal);
    EXPECT_THAT(ideal.error().message(), HasSubstr("stroke 1 of the cavity goes past the tooth"));
}

TEST(ExerciseFile, AnIdealShapeOfOnesOwnIsTakenAsItIsAndMustBeClosed) {
    const test::TemporaryFolder folder;
    TriangleMesh block = test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0));
    ASSERT_TRUE(writeStl(block, folder / "block.stl"));
    ASSERT_TRUE(writeStl(test::box(Vec3(-2, -2, -3), Vec3(2, 2, -1)), folder / "ideal.stl"));
    block.triangles.pop_back();
    ASSERT_TRUE(writeStl(block, folder / "open.stl"));
    test::writeText(
        folder / "lower.toml",
        "name = \"Lower\"\ntask = \"Grind.\"\ntooth = \"block.stl\"\nbur = \"330\"\nideal = \"ideal.stl\"\n");
    test::writeText(folder / "open.toml",
                    "name = \"Open\"\ntask = \"Grind.\"\ntooth = \"block.stl\"\nbur = \"330\"\nideal = \"open.stl\"\n");
    const auto lower = readExercise(folder / "lower.toml");
    ASSERT_TRUE(lower) << lower.error().message();
    EXPECT_EQ(lower->file, folder / "lower.toml");
    const auto tooth = exerciseTooth(*lower);
    ASSERT_TRUE(tooth) << tooth.error().message();
    const auto ideal = idealShape(*lower, *tooth);
    ASSERT_TRUE(ideal) << ideal.error().message();
    EXPECT_NEAR(*reportOn(*ideal).volume(), 32, 1e-3);
    const auto open = readExercise(folder / "open.toml");
    ASSERT_TRUE(open);
    const auto refused = idealShape(*open, *tooth);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message(), HasSubstr("is open (3 edges without a neighbour)"));
}

TEST(ExerciseFile, TheAmalgamOfABuiltInOneIsThatOfTheDentalMaterials) {
    const MaterialRegistry& own = *builtinExercise("amalgam-46")->materials;
    const MaterialRegistry& dental = dentalMaterials();
    EXPECT_EQ(own[own.find("amalgam").value()].numbers, dental[dental.find("amalgam").value()].numbers);
}

TEST(ExerciseFile, AFileThatIsNotThereIsRefused) {
    const auto missing = readExercise("/nowhere/pit.toml");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message(), HasSubstr("/nowhere/pit.toml"));
}

}  // namespace
}  // namespace tactooth

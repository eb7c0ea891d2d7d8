// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/motion_files.h"
#include "geometry/io/stl_reader.h"
#include "geometry/mesh/mesh_report.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

class ExerciseCommand : public test::MotionFiles {
protected:
    /// Lowers a block by `depth` mm.
    std::string lowered(double depth) {
        EXPECT_TRUE(writeStl(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), file("block.stl")));
        EXPECT_TRUE(writeStl(test::box(Vec3(-2, -2, -3), Vec3(2, 2, -depth)), file("ideal.stl")));
        writeText(file("lower.toml"),
                  "name = \"Lower the block\"\ntask = \"Grind.\"\ntooth = \"block.stl\"\nbur = \"330\"\n"
                  "ideal = \"ideal.stl\"\n");
        return file("lower.toml");
    }
};

TEST_F(ExerciseCommand, ShowsWhatIsToBeCutAndWritesIt) {
    const ProgramRun run = runTactooth({"exercise", lowered(1), "--out", file("shape.stl")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Lower the block"));
    EXPECT_THAT(run.out, HasSubstr("Pear carbide No. 330"));
    EXPECT_THAT(run.out, HasSubstr("rubric          near-ideal (Near the ideal preparation)\n"));
    EXPECT_THAT(run.out, ::testing::ContainsRegex("ideal cavity +1[56]\\.[0-9]+ mm3"));
    const auto shape = readStl(file("shape.stl"));
    ASSERT_TRUE(shape);
    EXPECT_NEAR(*reportOn(*shape).volume(), 32, 1e-3);
}

TEST_F(ExerciseCommand, SaysWhatTheStudentMayTake) {
    const std::string free = lowered(1);
    EXPECT_THAT(runTactooth({"exercise", free}).out, ::testing::Not(HasSubstr("instruments")));
    writeText(file("strict.toml"),
              test::readText(free) + "only_these_burs = true\ninstruments = [\"probe\", \"turbine\"]\n");
    const ProgramRun run = runTactooth({"exercise", file("strict.toml")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("these only"));
    EXPECT_THAT(run.out, HasSubstr("instruments     turbine, probe\n"));
}

TEST_F(ExerciseCommand, ChecksTheExampleThatComesWithTheProgram) {
    const ProgramRun run = runTactooth({"exercise", TACTOOTH_EXAMPLES "/exercise.toml"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("36, Lower left first molar"));
    EXPECT_THAT(run.out, HasSubstr("mm at least"));
}

TEST_F(ExerciseCommand, ChecksABuiltInOne) {
    const ProgramRun run = runTactooth({"exercise", "class-5-34"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Class V, hard"));
    EXPECT_THAT(run.out, HasSubstr("34, Lower left first premolar"));
    const ProgramRun unknown = runTactooth({"exercise", "nine"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, HasSubstr("there is no exercise 'nine'"));
}

TEST_F(ExerciseCommand, RefusesWhatCannotBePractisedWithASentence) {
    const ProgramRun nothing = runTactooth({"exercise", lowered(-1)});
    EXPECT_EQ(nothing.exitCode, 2);
    EXPECT_THAT(nothing.err, HasSubstr("leaves nothing to cut"));
    writeText(file("bad.toml"), "name = \"Bad\"\n");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"exercise", file("bad.toml")}, {"--exercise", file("bad.toml")}}) {
        const ProgramRun bad = runTactooth(command);
        EXPECT_EQ(bad.exitCode, 2);
        EXPECT_THAT(bad.err, HasSubstr("bad.toml, line 1: the key 'task' is missing"));
    }
}

}  // namespace
}  // namespace tactooth

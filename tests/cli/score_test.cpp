// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/motion_files.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kArea = std::numbers::pi * 0.25;  // mm^2, of the bur

class ScoreCommand : public test::MotionFiles {
protected:
    std::string block() {
        EXPECT_TRUE(writeStl(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), file("block.stl")));
        return file("block.stl");
    }
    /// The block with a round hole of 1 mm diameter, `depth` mm deep.
    std::string drilled(const std::string& name, double depth) {
        EXPECT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 4, 128), file("bur.stl")));
        const std::string path = trajectory({{0, 0, 0.01, 0.2}, {0.2, 0, 0.01, -depth}});
        const ProgramRun run = runTactooth({"cut", "--tooth", block(), "--tool", file("bur.stl"), "--trajectory", path,
                                            "--out", file(name + ".stl"), "--save", file(name + ".tactooth"),
                                            "--speed-rpm", "200000", "--feed", "rigid"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return file(name + ".tactooth");
    }
    static nlohmann::json scoreOf(const std::string& tooth, const std::string& target) {
        const ProgramRun run = runTactooth({"score", tooth, "--target", target, "--json"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return nlohmann::json::parse(run.out);
    }
};

TEST_F(ScoreCommand, ComparesAStudentsToothWithAnExperts) {
    const std::string expert = drilled("expert", 1.0), timid = drilled("timid", 0.8), bold = drilled("bold", 1.2);
    const auto shallow = scoreOf(timid, expert);
    EXPECT_NEAR(shallow["ideal_mm3"], kArea * 1.0, 0.02);
    EXPECT_NEAR(shallow["cleared_mm3"], kArea * 0.8, 0.02);
    EXPECT_NEAR(shallow["cleared_share"], 0.8, 0.01);
    EXPECT_LT(shallow["beyond_mm3"], 0.02);
    EXPECT_LT(shallow["deepest_beyond_mm"], 0.01);
    EXPECT_NEAR(shallow["likeness"], 1.6 / 1.8, 0.01);
    EXPECT_NEAR(shallow["removed_mm3"]["enamel"], kArea * 0.8, 0.002);
    const auto deep = scoreOf(bold, expert);
    EXPECT_NEAR(deep["cleared_share"], 1.0, 0.01);
    EXPECT_NEAR(deep["beyond_mm3"], kArea * 0.2, 0.02);
    EXPECT_NEAR(deep["deepest_beyond_mm"], 0.2, 0.005);
    const auto same = scoreOf(expert, expert);
    EXPECT_NEAR(same["likeness"], 1.0, 0.01);
    EXPECT_LT(same["deepest_beyond_mm"], 1e-3);
}

TEST_F(ScoreCommand, TheExportedSurfaceIsAsGoodATarget) {
    const std::string student = drilled("student", 0.7);
    (void)drilled("expert", 1.0);
    EXPECT_EQ(scoreOf(student, file("expert.stl"))["cleared_mm3"],
              scoreOf(student, file("expert.tactooth"))["cleared_mm3"]);
}

TEST_F(ScoreCommand, WritesATableForPeople) {
    const std::string student = drilled("student", 0.5);
    (void)drilled("expert", 1.0);
    const ProgramRun run = runTactooth({"score", student, "--target", file("expert.stl")});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("ideal cavity"), HasSubstr(" 50 %"), HasSubstr("likeness"),
                               HasSubstr("enamel"), Not(HasSubstr("pulp"))));
}

TEST_F(ScoreCommand, RefusesWhatCannotBeCompared) {
    const std::string student = drilled("student", 0.5);
    expectRefused(runTactooth({"score", block(), "--target", block()}), "is no saved tooth");
    expectRefused(runTactooth({"score", missing() + ".tactooth", "--target", block()}), "there is no such file");
    expectRefused(runTactooth({"score", student, "--target", missing()}), "there is no such file");
    expectRefused(runTactooth({"score", student, "--target", block()}), "leaves nothing to cut");
    expectRefused(runTactooth({"score", student}), "--target is required");
}

}  // namespace
}  // namespace tactooth

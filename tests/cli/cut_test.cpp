// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "cli/motion_files.h"
#include "geometry/io/mesh_file.h"
#include "geometry/mesh/mesh_report.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kPi = std::numbers::pi;

class CutCommand : public test::MotionFiles {
protected:
    /// A flat-ended bur of 1 mm.
    std::string bur() {
        EXPECT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 4, 128), file("bur.stl")));
        return file("bur.stl");
    }
    std::string block() {
        EXPECT_TRUE(writeStl(test::box(Vec3(-2, -2, -3), Vec3(2, 2, 0)), file("block.stl")));
        return file("block.stl");
    }
    ProgramRun cut(const std::string& tooth, const std::string& path, const std::vector<std::string>& more = {},
                   const std::string& speedRpm = "200000") {
        std::vector<std::string> arguments = {"cut", "--tooth", tooth,           "--tool",      bur(),   "--trajectory",
                                              path,  "--out",   file("cut.stl"), "--speed-rpm", speedRpm};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTactooth(arguments);
    }
    /// Straight down at x, from 0.2 mm above the block to `depth` below its top.
    std::string drillAt(double x, double depth) {
        std::vector<Row> rows;
        for (int i = 0; i <= 50; ++i) rows.push_back({0.01 * i, x, 0.01, 0.2 - (0.2 + depth) * i / 50});
        return trajectory(rows);
    }
    double volumeOf(const std::string& name) { return reportOn(*loadMesh(file(name))).signedVolume; }
};

TEST_F(CutCommand, ARigidFeedLeavesTheHoleOfTheBur) {
    const ProgramRun run = cut(block(), drillAt(0, 0.8), {"--feed", "rigid", "--removed", out()});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_TRUE(reportOn(*loadMesh(file("cut.stl"))).watertight());
    const double hole = kPi * 0.25 * 0.8;
    EXPECT_NEAR(48 - volumeOf("cut.stl"), hole, 0.003 * hole);
    const auto removed = table();
    EXPECT_THAT(removed.header, ::testing::StartsWith("t,enamel,dentin,pulp,caries,other,restoration"));
    EXPECT_NEAR(removed.rows.back()[1], hole, 0.003 * hole);
}

TEST_F(CutCommand, ABurOfTheCatalogueLeavesItsHole) {
    const ProgramRun run = runTactooth({"cut", "--tooth", block(), "--bur", "57", "--trajectory", drillAt(0, 0.8),
                                        "--out", file("cut.stl"), "--speed-rpm", "200000", "--feed", "rigid"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const double hole = kPi * 0.25 * 0.8;  // the blades of bur 57 turn within a diameter of 1 mm
    EXPECT_NEAR(48 - volumeOf("cut.stl"), hole, 0.03 * hole);
}

TEST_F(CutCommand, AMaterialOfTheUsersIsALayerAColumnAndAFile) {
    EXPECT_TRUE(writeStl(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 0)), file("filling.stl")));
    test::writeText(file("mine.toml"), "[composite]\nstiffness = 0.7\nremoval = 0.02\nnesting = 6\n");
    const ProgramRun run =
        cut(block(), drillAt(0, 0.8),
            {"--feed", "rigid", "--materials", file("mine.toml"), "--layer", "enamel=" + file("block.stl"), "--layer",
             "composite=" + file("filling.stl"), "--removed", out(), "--export-layers", file("layers"), "--save",
             file("filled.tactooth")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("removed    composite:"));
    const auto removed = table();
    EXPECT_THAT(removed.header, ::testing::EndsWith(",composite"));
    const double hole = kPi * 0.25 * 0.8;
    EXPECT_LT(removed.rows.back()[1], 0.02 * hole);
    EXPECT_NEAR(removed.rows.back().back(), hole, 0.02 * hole);
    EXPECT_NEAR(4 - volumeOf("layers/composite.stl"), hole, 0.004 * hole);
    const ProgramRun again = cut(file("filled.tactooth"), drillAt(0.3, 0.6), {"--feed", "rigid"});
    EXPECT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("removed    composite:"));
}

TEST_F(CutCommand, WritesWhatIsLeftOfEachLayer) {
    EXPECT_TRUE(writeStl(test::box(Vec3(-1, -1, -2), Vec3(1, 1, -0.5)), file("core.stl")));
    const std::string core = "dentin=" + file("core.stl");
    const ProgramRun run = cut(block(), drillAt(0, 0.8),
                               {"--feed", "rigid", "--layer", "enamel=" + file("block.stl"), "--layer", core,
                                "--export-layers", file("layers")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("of layer 'enamel' written"), HasSubstr("of layer 'dentin' written")));
    for (const char* name : {"layers/enamel.stl", "layers/dentin.stl"}) {
        EXPECT_TRUE(reportOn(*loadMesh(file(name))).watertight()) << name;
    }
    const double hole = kPi * 0.25 * 0.3;
    EXPECT_NEAR(6 - volumeOf("layers/dentin.stl"), hole, 0.004 * hole);
}

TEST_F(CutCommand, ASavedToothIsCutOnAsIfNothingHadBeen) {
    EXPECT_EQ(cut(block(), drillAt(-0.4, 0.5), {"--feed", "rigid", "--save", file("half.tactooth")}).exitCode, 0);
    const ProgramRun run = cut(file("half.tactooth"), drillAt(0.3, 0.6), {"--feed", "rigid"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, HasSubstr("of which before"));
    std::vector<Row> both;
    for (const double x : {-0.4, 0.3}) {
        both.push_back({both.empty() ? 0 : 1.0, x, 0.01, 0.2});
        both.push_back({both.back()[0] + 0.4, x, 0.01, x < 0 ? -0.5 : -0.6});
        both.push_back({both.back()[0] + 0.4, x, 0.01, 0.2});
    }
    const double inTwo = volumeOf("cut.stl");
    EXPECT_EQ(cut(block(), trajectory(both), {"--feed", "rigid"}).exitCode, 0);
    EXPECT_NEAR(volumeOf("cut.stl"), inTwo, 2e-4);
    EXPECT_LT(inTwo, 47.3);
}

TEST_F(CutCommand, ByLawAStillBurCutsNothingAndATurningOneLessThanTheHandGoes) {
    const std::string path = drillAt(0, 0.8);
    EXPECT_EQ(cut(block(), path, {}, "0").exitCode, 0);
    EXPECT_NEAR(volumeOf("cut.stl"), 48, 1e-4);
    EXPECT_EQ(cut(block(), path, {"--material", "dentin", "--forces", out()}).exitCode, 0);
    const double removed = 48 - volumeOf("cut.stl");
    EXPECT_GT(removed, 0.005);
    EXPECT_LT(removed, kPi * 0.25 * 0.6);
    EXPECT_GT(table().at(50, "fz"), 0.05) << "the tooth pushes back";
}

TEST_F(CutCommand, ReportsWhenATissueWasReached) {
    EXPECT_TRUE(writeStl(test::box(Vec3(-1.5, -1.5, -2.5), Vec3(1.5, 1.5, -0.4)), file("core.stl")));
    const ProgramRun run = cut(block(), drillAt(0, 0.8),
                               {"--feed", "rigid", "--events", out(), "--layer", "enamel=" + block(), "--layer",
                                "dentin=" + file("core.stl")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::ifstream events(out());
    std::string head;
    std::string contact;
    std::string dentin;
    std::getline(events, head);
    std::getline(events, contact);
    std::getline(events, dentin);
    EXPECT_EQ(head, "t,event,x,y,z");
    EXPECT_THAT(contact, HasSubstr(",first contact,0,0.01,"));
    EXPECT_THAT(dentin, AllOf(::testing::StartsWith("0.3"), HasSubstr(",dentin reached,")));
    EXPECT_FALSE(std::getline(events, head)) << head;
}

TEST_F(CutCommand, WritesVoxelsOrSaysThatItCannot) {
    const std::string path = drillAt(0, 0.3);
    const ProgramRun run = cut(block(), path, {"--feed", "rigid", "--voxel", "0.1", "--vdb", file("cut.vdb")});
#ifdef TACTOOTH_HAS_OPENVDB
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("voxels written to " + file("cut.vdb")));
    EXPECT_THAT(test::readText(file("cut.vdb")), ::testing::StartsWith(" BDV"));
    expectRefused(cut(block(), path, {"--vdb", file("no/cut.vdb")}), "no/cut.vdb");
#else
    expectRefused(run, "built without OpenVDB");
    EXPECT_FALSE(std::filesystem::exists(file("cut.stl"))) << "refused before anything is cut";
#endif
}

TEST_F(CutCommand, RefusesWhatItCannotCutOrSave) {
    const std::string path = drillAt(0, 0.3);
    expectRefused(cut(file("missing.tactooth"), path), "missing.tactooth: there is no such file");
    EXPECT_EQ(cut(block(), path, {"--feed", "rigid", "--save", file("half.tactooth")}).exitCode, 0);
    const std::string half = file("half.tactooth");
    expectRefused(cut(half, path, {"--layer", "dentin=" + block()}), "a saved tooth has its own layers");
    expectRefused(cut(half, path, {"--voxel", "0.05"}), "keeps the spacing that it was cut with, 25 um");
    EXPECT_EQ(cut(half, path, {"--voxel", "0.025"}).exitCode, 0);
    expectRefused(cut(text("broken.tactooth", "TACTOOTH"), path), "broken.tactooth, byte 8: the file is cut short");
    expectRefused(cut(block(), path, {"--save", file("no/folder.tactooth")}), "no/folder.tactooth");
}

}  // namespace
}  // namespace tactooth

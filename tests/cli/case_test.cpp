// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>

#include "cli/cli_test.h"
#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// Two adjacent blocks of enamel and dentin, as files of the teeth L6 and L7, in centimetres.
class CaseCommand : public ::testing::Test {
protected:
    void SetUp() override {
        for (const auto& [name, x] : {std::pair("L6", 0.0F), std::pair("L7", 1.0F)}) {
            writeBlock(std::string(name) + "_outer.stl", Vec3(-0.4, -0.4, -1.2), Vec3(0.4, 0.4, 0.8), x);
            writeBlock(std::string(name) + "_dentin.stl", Vec3(-0.3, -0.3, -1.1), Vec3(0.3, 0.3, 0.5), x);
        }
    }

    void writeBlock(const std::string& name, const Vec3& low, const Vec3& high, float x) {
        TriangleMesh block = test::box(low, high);
        for (Vec3f& vertex : block.vertices) vertex.x() += x;
        ASSERT_TRUE(writeStl(block, folder_ / ("scan/" + name)));
    }

    ProgramRun makeCase(const std::string& out) {
        return runTactooth({"case", "new", folder_ / out, "--from", folder_ / "scan", "--quadrant", "3", "--title",
                            "Two blocks", "--licence", "CC0-1.0"});
    }

    struct Folder : test::TemporaryFolder {
        Folder() { fs::create_directories(*this / "scan"); }
    } folder_;
};

TEST_F(CaseCommand, NewSaysWhatItAssumed) {
    const ProgramRun run = makeCase("two.ttcase");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("tooth L6 (FDI 36)"), HasSubstr("Units taken as cm"),
                               HasSubstr("outer: closed and sound as it came"), HasSubstr("licence: CC0-1.0")));
    const ProgramRun info = runTactooth({"case", "info", folder_ / "two.ttcase"});
    EXPECT_EQ(info.exitCode, 0);
    EXPECT_THAT(info.out,
                AllOf(HasSubstr("Two blocks"), HasSubstr("from L6_outer.stl"), HasSubstr("Units taken as cm")));
}

TEST_F(CaseCommand, AFolderThatHoldsSomethingIsRefusedBeforeTheImport) {
    fs::create_directories(folder_ / "full/of things");
    const ProgramRun run = makeCase("full");
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("full: there is something already; give a new folder"));
}

TEST_F(CaseCommand, AFolderIsPackedAndBothOpen) {
    ASSERT_EQ(makeCase("two").exitCode, 0);
    const ProgramRun pack = runTactooth({"case", "pack", folder_ / "two", "--out", folder_ / "packed.ttcase"});
    EXPECT_EQ(pack.exitCode, 0) << pack.err;
    for (const char* const name : {"two", "packed.ttcase"}) {
        const ProgramRun check = runTactooth({"case", "check", folder_ / name});
        EXPECT_EQ(check.exitCode, 0) << check.err;
        EXPECT_THAT(check.out, AllOf(HasSubstr("L6: 12 triangles, closed"), HasSubstr("can be opened"),
                                     Not(HasSubstr("overlap"))));
    }
}

TEST_F(CaseCommand, CheckReportsWhatMightSurprise) {
    ASSERT_EQ(makeCase("two").exitCode, 0);
    std::ofstream(folder_ / "two/readme.txt") << "hello";
    const ProgramRun check = runTactooth({"case", "check", folder_ / "two"});
    EXPECT_THAT(check.out, HasSubstr("readme.txt: case.toml does not name this file"));
    fs::remove(folder_ / "two/teeth/L6/outer.stl");
    const ProgramRun broken = runTactooth({"case", "check", folder_ / "two"});
    EXPECT_EQ(broken.exitCode, 1);
    EXPECT_THAT(broken.err, HasSubstr("teeth/L6/outer.stl: there is no such file in the case"));
}

TEST_F(CaseCommand, CheckFindsUnusedFilesWhereABurLiesAtTheTop) {
    ASSERT_EQ(makeCase("two").exitCode, 0);
    ASSERT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 6, 24), folder_ / "two/mine.stl"));
    std::ofstream(folder_ / "two/mine.toml") << "surface = \"mine.stl\"\n";
    std::ofstream(folder_ / "two/case.toml", std::ios::app) << "\n[[bur]]\nfile = \"mine.toml\"\n";
    std::ofstream(folder_ / "two/teeth/notes.txt") << "hello";
    const ProgramRun check = runTactooth({"case", "check", folder_ / "two"});
    EXPECT_EQ(check.exitCode, 0) << check.err;
    EXPECT_THAT(check.out, HasSubstr("teeth/notes.txt: case.toml does not name this file"));
    EXPECT_THAT(check.out, Not(HasSubstr("mine.stl: case.toml")));
}

TEST_F(CaseCommand, CaseIsCutWithItsOwnBurInTheFrameOfTheToothThatIsWorkedOn) {
    ASSERT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 6, 24), folder_ / "mine.stl"));
    std::ofstream(folder_ / "mine.toml") << "name = \"Mine\"\nsharpness = 1.5\n";
    const ProgramRun made = runTactooth({"case", "new", folder_ / "two.ttcase", "--from", folder_ / "scan",
                                         "--quadrant", "3", "--bur", folder_ / "mine.stl"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    std::ofstream(folder_ / "path.csv") << "t,x,y,z,qw,qx,qy,qz\n0,0,0,30,1,0,0,0\n0.5,0,0,0,1,0,0,0\n";
    const ProgramRun cut =
        runTactooth({"cut", "--case", folder_ / "two.ttcase", "--work-on", "37", "--trajectory", folder_ / "path.csv",
                     "--speed-rpm", "200000", "--feed", "rigid", "--voxel", "0.1", "--out", folder_ / "cut.stl"});
    ASSERT_EQ(cut.exitCode, 0) << cut.err;
    EXPECT_THAT(cut.out, AllOf(HasSubstr("enamel"), HasSubstr("dentin")));
    EXPECT_TRUE(reportOn(readStl(folder_ / "cut.stl").value()).watertight());
}

TEST_F(CaseCommand, CaseIsTouched) {
    ASSERT_EQ(makeCase("two").exitCode, 0);
    ASSERT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.5, 6, 24), folder_ / "tool.stl"));
    std::ofstream path(folder_ / "path.csv");
    path << "t,x,y,z,qw,qx,qy,qz\n";
    for (int i = 0; i < 400; ++i) path << i * 0.001 << ",0,0," << 30 - 0.1 * i << ",1,0,0,0\n";
    path.close();
    const ProgramRun feel = runTactooth({"feel", "--tooth", folder_ / "two", "--tool", folder_ / "tool.stl",
                                         "--trajectory", folder_ / "path.csv", "--out", folder_ / "out.csv"});
    EXPECT_EQ(feel.exitCode, 0) << feel.err;
    EXPECT_THAT(feel.out, AllOf(HasSubstr("400 ticks"), Not(HasSubstr("largest force 0.000"))));
}

TEST_F(CaseCommand, AToothThatIsNotThereIsRefused) {
    ASSERT_EQ(makeCase("two").exitCode, 0);
    const ProgramRun run = runTactooth({"render", folder_ / "two", "--work-on", "48", "--out", folder_ / "x.png"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("there is no tooth '48' in this case; it has L6, L7."));
}

TEST_F(CaseCommand, WrongChoicesAreRefused) {
    EXPECT_THAT(runTactooth({"case", "new", folder_ / "x", "--from", folder_ / "scan", "--units", "ells"}).err,
                HasSubstr("is no unit"));
    EXPECT_EQ(runTactooth({"case", "new", folder_ / "x", "--from", folder_ / "nothing"}).exitCode, 2);
    EXPECT_EQ(runTactooth({"case", "check", folder_ / "scan"}).exitCode, 1);
    EXPECT_FALSE(fs::exists(folder_ / "x"));
}

}  // namespace
}  // namespace tactooth

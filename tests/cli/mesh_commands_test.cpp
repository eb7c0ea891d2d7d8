// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_test.h"
#include "geometry/io/stl_reader.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;

class MeshCommands : public ::testing::Test {
protected:
    std::string ball() { return stl("ball.stl", test::sphere(Vec3::Zero(), 5, 40, 26)); }  // 2000 triangles
    std::string bowl() {
        TriangleMesh open = test::sphere(Vec3::Zero(), 5, 40, 26);
        open.triangles.resize(1500);
        return stl("bowl.stl", open);
    }
    std::string out() { return folder_ / "out.stl"; }
    MeshReport written() { return reportOn(readStl(out()).value()); }

    void expectRefused(const ProgramRun& run, const std::string& sentence) {
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_THAT(run.err, HasSubstr(sentence));
        EXPECT_FALSE(std::filesystem::exists(out()));
    }

private:
    std::string stl(const std::string& name, const TriangleMesh& mesh) {
        EXPECT_TRUE(writeStl(mesh, folder_ / name));
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

TEST_F(MeshCommands, SimplifyKeepsAShareAndTheBallClosed) {
    const ProgramRun run = runTactooth({"simplify", ball(), "--keep", "25%", "--out", out()});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("ball.stl: 2000 triangles, closed, 1 shell"),
                               HasSubstr("out.stl: 500 triangles, closed, 1 shell"), HasSubstr("greatest deviation")));
    EXPECT_EQ(written().triangles, 500U);
    EXPECT_TRUE(written().watertight());
    EXPECT_NEAR(written().signedVolume, reportOn(readStl(ball()).value()).signedVolume, 15);
}

TEST_F(MeshCommands, SimplifyKeepsANumber) {
    EXPECT_EQ(runTactooth({"simplify", ball(), "--keep", "300", "--out", out()}).exitCode, 0);
    EXPECT_EQ(written().triangles, 300U);
}

TEST_F(MeshCommands, SimplifyRefusesWhatIsNoShare) {
    for (const char* keep : {"0%", "101%", "-5", "2.5", "half", "", "%", "nan%", "1e300"}) {
        SCOPED_TRACE(keep);
        expectRefused(runTactooth({"simplify", ball(), "--keep", keep, "--out", out()}), "neither a share");
    }
}

TEST_F(MeshCommands, SimplifyRefusesAnOpenSurface) {
    expectRefused(runTactooth({"simplify", bowl(), "--keep", "50%", "--out", out()}),
                  "bowl.stl: the surface is open (52 edges without a neighbour), so it has no inside");
}

TEST_F(MeshCommands, SubdivideOnceMakesFourOfOne) {
    const ProgramRun run = runTactooth({"subdivide", ball(), "--out", out()});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, HasSubstr("out.stl: 8000 triangles, closed, 1 shell"));
    EXPECT_TRUE(written().watertight());
}

TEST_F(MeshCommands, SubdivideTakesTimesOrTriangles) {
    EXPECT_EQ(runTactooth({"subdivide", ball(), "--times", "2", "--out", out()}).exitCode, 0);
    EXPECT_EQ(written().triangles, 32000U);
    EXPECT_EQ(runTactooth({"subdivide", ball(), "--triangles", "5000", "--out", out()}).exitCode, 0);
    EXPECT_EQ(written().triangles, 5000U);
    EXPECT_NEAR(written().area, reportOn(readStl(ball()).value()).area, 1e-3);
}

TEST_F(MeshCommands, SubdivideWorksOnAnOpenSurface) {
    EXPECT_EQ(runTactooth({"subdivide", bowl(), "--times", "1", "--out", out()}).exitCode, 0);
    EXPECT_EQ(written().triangles, 6000U);
}

TEST_F(MeshCommands, SubdivideRefusesTooMuchAndBoth) {
    expectRefused(runTactooth({"subdivide", ball(), "--times", "12", "--out", out()}), "are the most; ask for fewer");
    expectRefused(runTactooth({"subdivide", ball(), "--times", "1", "--triangles", "9", "--out", out()}), "--help");
}

TEST_F(MeshCommands, RefuseAMissingFile) {
    expectRefused(runTactooth({"simplify", "/nowhere.stl", "--keep", "50%", "--out", out()}), "there is no such file");
    expectRefused(runTactooth({"subdivide", "/nowhere.stl", "--out", out()}), "there is no such file");
}

}  // namespace
}  // namespace tactooth

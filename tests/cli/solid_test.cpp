// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "cli/motion_files.h"
#include "geometry/io/mesh_file.h"
#include "geometry/mesh/mesh_report.h"

// Every command decides in the same way whether a surface is a solid.

namespace tactooth {
namespace {

using namespace test;

TriangleMesh turned(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other) {
    append(mesh, other);
    return mesh;
}

class Solids : public test::MotionFiles {
protected:
    std::string surface(const TriangleMesh& mesh) {
        EXPECT_TRUE(writeStl(mesh, file("tooth.stl")));
        return file("tooth.stl");
    }
    nlohmann::json info() { return nlohmann::json::parse(runTactooth({"info", "--json", file("tooth.stl")}).out); }
    std::string bur() {
        EXPECT_TRUE(writeStl(cylinder(Vec3::Zero(), 0.5, 8, 64), file("bur.stl")));
        return file("bur.stl");
    }
    /// Straight down into a block with its top at z = 5, to `depth` below it.
    std::string bore(double depth) {
        std::vector<Row> rows;
        for (int i = 0; i <= 50; ++i) rows.push_back({0.01 * i, 0.01, 0.02, 5.2 - (0.2 + depth) * i / 50});
        return trajectory(rows);
    }
    ProgramRun cut(const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments = {
            "cut",           "--tooth",     file("tooth.stl"), "--tool", bur(),   "--trajectory", bore(5), "--out",
            file("cut.stl"), "--speed-rpm", "200000",          "--feed", "rigid", "--voxel",      "0.05"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTactooth(arguments);
    }
    /// Expects that all commands refuse the surface for the same reason.
    void expectRefusedByAll(const std::string& reason) {
        const std::string path = trajectory({{0, 0, 0, 9}, {0.001, 0, 0, 8.9}});
        const std::vector<std::vector<std::string>> commands = {
            {"contact", "--tooth", file("tooth.stl"), "--tool", bur(), "--poses", path, "--out", out()},
            {"feel", "--tooth", file("tooth.stl"), "--tool", bur(), "--trajectory", path, "--out", out()},
            {"cut", "--tooth", file("tooth.stl"), "--tool", bur(), "--trajectory", path, "--out", out(), "--speed-rpm",
             "200000"},
            {"simplify", file("tooth.stl"), "--keep", "50%", "--out", out()},
            {"case", "new", file("out.csv.ttcase"), "--from", file("tooth.stl")}};
        for (const auto& command : commands) {
            SCOPED_TRACE(command.front());
            const ProgramRun run = runTactooth(command);
            EXPECT_EQ(run.exitCode, 2);
            EXPECT_THAT(run.err, HasSubstr(reason));
            EXPECT_EQ(run.err[run.err.size() - 2], '.');
            EXPECT_FALSE(std::filesystem::exists(out()));
            EXPECT_FALSE(std::filesystem::exists(file("out.csv.ttcase")));
        }
    }
};

const TriangleMesh kBlock = box(Vec3(-5, -5, -15), Vec3(5, 5, 5));  // 2000 mm^3
const TriangleMesh kVoid = box(Vec3(-3, -3, -12), Vec3(3, 3, 0));   // 432 mm^3, its top 5 mm below the block's

TEST_F(Solids, AnInnerShellIsAVoidWhicheverWayItFaces) {
    for (const TriangleMesh& mesh :
         {together(kBlock, kVoid), together(kBlock, turned(kVoid)), together(turned(kBlock), kVoid),
          together(kVoid, turned(kBlock)), turned(together(kBlock, kVoid))}) {
        surface(mesh);
        const nlohmann::json facts = info();
        EXPECT_EQ(facts["closed"], true);
        EXPECT_NEAR(facts["volume"].get<double>(), 1568, 1e-3);
        const ProgramRun run = cut({"--removed", out()});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        // The bur goes 5 mm deep, to the start of the void.
        constexpr double kRemoved = 0.25 * 3.14159265 * 5;
        EXPECT_NEAR(table().rows.back()[1], kRemoved, 0.004 * kRemoved);
        const MeshReport left = reportOn(*loadMesh(file("cut.stl")));
        EXPECT_TRUE(left.watertight());
        EXPECT_NEAR(left.signedVolume, 1568 - kRemoved, 0.004 * kRemoved);
    }
}

TEST_F(Solids, BodiesThatReachIntoEachOtherAreRefusedByAll) {
    const std::vector<TriangleMesh> bodies = {together(kBlock, box(Vec3(2, 2, 2), Vec3(8, 8, 8))),
                                              together(kBlock, turned(box(Vec3(2, 2, 2), Vec3(8, 8, 8)))),
                                              together(kBlock, sphere(Vec3(0, 0, 5), 3, 24, 16)),
                                              together(kBlock, cylinder(Vec3(0.1, 0.2, -20), 1, 40, 24)),
                                              together(together(kBlock, box(Vec3(4, -5, -15), Vec3(14, 5, 5))), kVoid)};
    for (const TriangleMesh& mesh : bodies) {
        surface(mesh);
        expectRefusedByAll("reach into each other");
        const nlohmann::json facts = info();
        EXPECT_TRUE(facts["volume"].is_null());
        EXPECT_EQ(facts["watertight"], false);
        EXPECT_FALSE(facts["findings"].empty());
        EXPECT_THAT(runTactooth({"info", file("tooth.stl")}).out, HasSubstr("reach into each other by"));
    }
}

TEST_F(Solids, AnEdgeOfFourTrianglesHasAnInside) {
    // Two blocks that touch along an edge. The bur cuts 3 mm deep in one of them.
    surface(together(box(Vec3(-5, -5, 0), Vec3(0, 0, 5)), box(Vec3(0, 0, 0), Vec3(5, 5, 5))));
    EXPECT_EQ(info()["closed"], true);
    EXPECT_NEAR(info()["volume"].get<double>(), 250, 1e-3);
    EXPECT_TRUE(writeStl(sphere(Vec3(0, 0, 0.5), 0.5, 32, 16), file("ball.stl")));
    const std::string poses = trajectory({{0, -2.5, -2.5, 3}});
    const ProgramRun run = runTactooth(
        {"contact", "--tooth", file("tooth.stl"), "--tool", file("ball.stl"), "--poses", poses, "--out", out()});
    ASSERT_EQ(run.exitCode, 0);
    EXPECT_NEAR(table().at(0, "depth"), 2, 0.01);
    EXPECT_EQ(cut().exitCode, 0);
}

TEST_F(Solids, ASpeckFarAwayIsSaidAndChangesNothing) {
    for (const double far : {40.0, 400.0, -4000.0}) {
        surface(together(box(Vec3(far, 0, 0), Vec3(far + 0.2, 0.2, 0.2)), kBlock));
        EXPECT_EQ(info()["box"]["size"], nlohmann::json({10.0, 10.0, 20.0}));
        const ProgramRun run = runTactooth({"case", "new", file("case"), "--from", file("tooth.stl")});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        EXPECT_THAT(run.out, AllOf(HasSubstr("the longest side would be 20.0 mm"), HasSubstr("1 specks beside")));
        std::filesystem::remove_all(file("case"));
        EXPECT_THAT(cut().err, HasSubstr("1 specks beside the surface were dropped"));
    }
}

}  // namespace
}  // namespace tactooth

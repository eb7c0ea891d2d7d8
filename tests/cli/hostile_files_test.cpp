// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files for all readers of the real program: a few in the ordinary tests, 5,000 with TACTOOTH_HOSTILE=3400.
#include <algorithm>

#include "cli/cli_test.h"
#include "cli/hostile_folder.h"
#include "geometry/io/mesh_file.h"
#include "support/mutation.h"
#include "support/sanitizer.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

/// A kind of file: undamaged seeds, and the commands that the program runs on them.
struct Kind {
    std::string ending;
    std::vector<std::string> seeds;
    std::vector<Attack> attacks;
};

/// The same surface as OBJ text.
std::string asObj(const TriangleMesh& mesh) {
    std::string text;
    for (const Vec3f& v : mesh.vertices)
        text += "v " + std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z()) + "\n";
    for (const Triangle& t : mesh.triangles)
        text +=
            "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
    return text;
}

std::string asPly(const TriangleMesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3f& v : mesh.vertices)
        text += std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z()) + "\n";
    for (const Triangle& t : mesh.triangles)
        text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    return text;
}

class HostileFiles : public ::testing::Test {
protected:
    /// The fuzzers' seeds with this ending.
    static std::vector<std::string> corpus(const std::string& name, const std::string& ending) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TACTOOTH_CORPUS) / name)) {
            if (entry.path().extension() == ending) files.push_back(entry.path());
        }
        std::ranges::sort(files);
        std::vector<std::string> seeds;
        for (const auto& file : files) seeds.push_back(readText(file));
        return seeds;
    }

    /// Makes a file with the program itself.
    std::string made(const Attack& command, const std::string& file) {
        const WatchedRun run = watchTactooth(command, folder_.input("").parent_path().parent_path());
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return readText(folder_.input(file));
    }

    static std::vector<std::string> joined(std::vector<std::string> some, const std::vector<std::string>& others) {
        some.insert(some.end(), others.begin(), others.end());
        return some;
    }

    /// Damages a seed of each kind in turn and runs a random attack.
    void attackWith(const std::vector<Kind>& kinds, std::size_t runs, unsigned chance) {
        std::mt19937 random(chance);
        for (std::size_t i = 0; i < runs; ++i) {
            const Kind& kind = kinds[i % kinds.size()];
            std::string bytes = kind.seeds[below(random, kind.seeds.size())];
            for (std::size_t changes = 1 + below(random, 3); changes > 0; --changes) mutate(bytes, kind.seeds, random);
            const std::string name = "in/hostile" + kind.ending;
            const std::filesystem::path file = folder_.input("hostile" + kind.ending);
            std::filesystem::create_directories(file.parent_path());
            writeText(file, bytes);
            const Attack& attack = kind.attacks[below(random, kind.attacks.size())];
            const std::string fault = folder_.tried(attack, name);
            if (fault.empty()) continue;
            const auto kept = std::filesystem::temp_directory_path() /
                              ("tactooth-hostile-" + std::to_string(chance) + "-" + std::to_string(i) + kind.ending);
            writeText(kept, bytes);
            ADD_FAILURE() << fault << "\n    of: " << shownAttack(attack, kept);
        }
        for (const auto& [code, count] : folder_.ends()) RecordProperty("exit" + std::to_string(code), count);
    }

    HostileFolder folder_;
};

const std::vector<Attack> kOnSurfaces = {
    {"info", "@"},
    {"info", "@", "--json"},
    {"contact", "--tooth", "@", "--tool", "in/ball.stl", "--poses", "in/poses.csv", "--out", "out/a.csv"},
    {"contact", "--tooth", "in/box.stl", "--tool", "@", "--poses", "in/poses.csv", "--out", "out/a.csv"},
    {"feel", "--tooth", "@", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--out", "out/a.csv"},
    {"feel", "--tooth", "in/box.stl", "--tool", "@", "--trajectory", "in/poses.csv", "--out", "out/a.csv"},
    {"feel", "--tooth", "@", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--out", "out/a.csv", "--mode",
     "penalty"},
    {"cut", "--tooth", "@", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--speed-rpm", "200000", "--voxel",
     "0.1", "--out", "out/a.stl", "--forces", "out/a.csv"},
    {"cut", "--tooth", "in/box.stl", "--tool", "@", "--trajectory", "in/poses.csv", "--speed-rpm", "200000", "--voxel",
     "0.1", "--feed", "rigid", "--out", "out/a.stl"},
    {"cut", "--tooth", "in/box.stl", "--layer", "pulp=@", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv",
     "--speed-rpm", "9000", "--voxel", "0.1", "--out", "out/a.stl"},
    {"simplify", "@", "--keep", "50%", "--out", "out/a.stl"},
    {"subdivide", "@", "--out", "out/a.stl"},
    {"assess", "@", "--expert", "in/cut.stl", "--original", "in/box.stl", "--out", "out/report"},
    {"assess", "in/cut.stl", "--expert", "@", "--original", "in/box.stl", "--out", "out/report", "--align"},
    {"case", "new", "out/case", "--from", "@"},
    {"case", "new", "out/case.ttcase", "--from", "in/box.stl", "--bur", "@"},
};

const std::vector<Attack> kOnMotions = {
    {"contact", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--poses", "@", "--out", "out/a.csv"},
    {"feel", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "@", "--out", "out/a.csv"},
    {"feel", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "@", "--out", "out/a.csv", "--freedom",
     "6", "--friction", "0.2"},
    {"cut", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "@", "--speed-rpm", "200000", "--voxel",
     "0.1", "--out", "out/a.stl", "--removed", "out/a.csv", "--events", "out/b.csv"},
    {"cut", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "@", "--speed-rpm", "200000", "--voxel",
     "0.1", "--feed", "rigid", "--out", "out/a.stl", "--forces", "out/a.csv"},
};

const std::vector<Attack> kOnTexts = {
    {"feel", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--out", "out/a.csv",
     "--materials", "@"},
    {"cut", "--tooth", "in/box.stl", "--tool", "@", "--trajectory", "in/poses.csv", "--speed-rpm", "200000", "--voxel",
     "0.1", "--out", "out/a.stl"},
    {"sound", "--profile", "in/profile.csv", "--sounds", "@", "--out", "out/a.wav"},
    {"sound", "--profile", "in/profile.csv", "--materials", "@", "--out", "out/a.wav"},
    {"exercise", "@"},
    {"assess", "in/cut.stl", "--expert", "in/cut.stl", "--original", "in/box.stl", "--rubric", "@", "--out",
     "out/report"},
    {"case", "new", "out/case", "--from", "in/box.stl", "--materials", "@"},
};

TEST_F(HostileFiles, EndInOneSentenceOrAResult) {
    const auto ball = loadMesh(folder_.input("ball.stl"));
    ASSERT_TRUE(ball);
    std::vector<std::string> stl = joined(corpus("stl", ".stl"), {readText(folder_.input("box.stl"))});
    stl.push_back(readText(folder_.input("ball.stl")));
    const std::string caseText = made({"case", "new", "in/case", "--from", "in/box.stl"}, "case/case.toml");
    const std::string packed = made({"case", "pack", "in/case", "--out", "in/box.ttcase"}, "box.ttcase");
    const std::string tooth =
        made({"cut", "--tooth", "in/box.stl", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--speed-rpm",
              "200000", "--voxel", "0.2", "--out", "in/cut.stl", "--save", "in/cut.tactooth"},
             "cut.tactooth");
    for (const char* name : {"a.stl", "bur.stl", "mine.stl"}) {
        std::filesystem::copy_file(folder_.input("ball.stl"), folder_.input(name));
    }
    std::filesystem::copy(folder_.input("case"), folder_.input("hostile"), std::filesystem::copy_options::recursive);
    const Attack feel = {"feel",         "--case",       "@",     "--tool",   "in/ball.stl",
                         "--trajectory", "in/poses.csv", "--out", "out/a.csv"};
    attackWith({{".stl", stl, kOnSurfaces},
                {".csv", joined(corpus("csv", ".csv"), {readText(folder_.input("poses.csv"))}), kOnMotions},
                {".toml", joined(corpus("toml", ".toml"), {readText(TACTOOTH_EXAMPLES "/exercise.toml")}), kOnTexts},
                {".obj", joined(corpus("mesh", ".obj"), {asObj(*ball)}), kOnSurfaces},
                {"/case.toml", {caseText}, {{"case", "check", "@"}, {"case", "info", "@"}, feel}},
                {".ply", joined(corpus("mesh", ".ply"), {asPly(*ball)}), kOnSurfaces},
                {".ttcase",
                 joined(corpus("case", ".ttcase"), {packed}),
                 {{"case", "check", "@"}, {"case", "info", "@"}, feel}},
                {".csv",
                 joined(corpus("csv", ".csv"), {readText(folder_.input("profile.csv"))}),
                 {{"sound", "--profile", "@", "--out", "out/a.wav", "--spectrogram", "out/a.png"}}},
                {".tactooth",
                 joined(corpus("tooth", ".tactooth"), {tooth}),
                 {{"score", "@", "--target", "in/cut.stl", "--json"},
                  {"assess", "@", "--expert", "in/cut.stl", "--out", "out/report"},
                  {"cut", "--tooth", "@", "--tool", "in/ball.stl", "--trajectory", "in/poses.csv", "--speed-rpm", "1e5",
                   "--out", "out/a.stl", "--export-layers", "out/layers"}}},
                {".wav",
                 corpus("recording", ".wav"),
                 {{"sound", "--profile", "in/profile.csv", "--sounds", "@", "--out", "out/a.wav"}}}},
               hostileRuns(cases<std::size_t>(150, 40)), 20261125);
    EXPECT_GT(folder_.ends().count(0), 0U);
    EXPECT_GT(folder_.ends().count(2), 0U);
}

}  // namespace
}  // namespace tactooth

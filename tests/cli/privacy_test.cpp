// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Files for other people contain nothing about their author, the place of their making or the command.
#include <unistd.h>

#include <array>

#include "cli/cli_test.h"
#include "geometry/io/stl_writer.h"
#include "session/simulation/tooth_file.h"
#include "support/shapes.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

class Privacy : public ::testing::Test {
protected:
    Privacy() {
        std::filesystem::create_directory(home_);
        EXPECT_TRUE(writeStl(box(Vec3(-4, -4, -6), Vec3(4, 4, 0)), home_ / "molar.stl"));
        EXPECT_TRUE(writeStl(sphere(Vec3(0, 0, -3), 1, 12, 8), home_ / "pulp.stl"));
        EXPECT_TRUE(writeStl(sphere(Vec3(0, 0, 0.5), 0.5, 12, 8), home_ / "ball.stl"));
        writeText(home_ / "way.csv", "t,x,y,z,qw,qx,qy,qz\n0,0,0,0.1,1,0,0,0\n0.1,0,0,-0.2,1,0,0,0\n");
        writeText(home_ / "profile.csv", "t,speed_rpm,power,material\n0,300000,0,none\n0.02,300000,5,enamel\n");
        writeText(home_ / "materials.toml", "[enamel]\nstiffness = 0.9\n");
    }

    [[nodiscard]] std::string in(const std::string& name) const { return home_ / name; }

    static void ranWell(const std::vector<std::string>& arguments) {
        const ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
    }

    /// Expects that no file in the folder names the folder, the machine, the user or an option.
    void expectSilent(const std::filesystem::path& folder) const {
        std::array<char, 256> machine{};
        ::gethostname(machine.data(), machine.size() - 1);
        std::vector<std::string> words = {"anna-miller", home_.parent_path(), "--tool", "--save", machine.data()};
        if (const char* user = std::getenv("USER"); user != nullptr && std::string(user).size() > 4)
            words.push_back(user);
        std::size_t files = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (!entry.is_regular_file()) continue;
            ++files;
            const std::string bytes = readText(entry.path());
            for (const std::string& word : words) {
                EXPECT_TRUE(word.size() < 4 || bytes.find(word) == std::string::npos) << entry.path() << ": " << word;
            }
        }
        EXPECT_GT(files, 0U);
    }

    TemporaryFolder folder_;
    std::filesystem::path home_ = folder_ / "anna-miller";
    std::filesystem::path out_ = home_ / "out";
};

TEST_F(Privacy, NoFileNamesTheFolderTheMachineOrTheCommand) {
    std::filesystem::create_directory(out_);
    std::vector<std::string> cut = {"cut",
                                    "--tooth",
                                    in("molar.stl"),
                                    "--layer",
                                    "pulp=" + in("pulp.stl"),
                                    "--tool",
                                    in("ball.stl"),
                                    "--trajectory",
                                    in("way.csv"),
                                    "--speed-rpm",
                                    "200000",
                                    "--voxel",
                                    "0.1",
                                    "--out",
                                    out_ / "cut.stl",
                                    "--save",
                                    out_ / "cut.tactooth",
                                    "--forces",
                                    out_ / "f.csv",
                                    "--removed",
                                    out_ / "r.csv",
                                    "--events",
                                    out_ / "e.csv",
                                    "--export-layers",
                                    out_ / "layers"};
#ifdef TACTOOTH_HAS_OPENVDB
    cut.insert(cut.end(), {"--vdb", out_ / "cut.vdb"});
#endif
    ranWell(cut);
    ranWell({"sound", "--profile", in("profile.csv"), "--out", out_ / "s.wav", "--spectrogram", out_ / "s.png"});
    ranWell({"case", "new", out_ / "case", "--from", in("molar.stl"), "--bur", in("ball.stl"), "--materials",
             in("materials.toml")});
    ranWell({"case", "pack", out_ / "case", "--out", out_ / "case.ttcase"});
    ranWell({"simplify", in("ball.stl"), "--keep", "50%", "--out", out_ / "fewer.stl"});
    ranWell({"bur", "330", "--out", out_ / "bur.stl"});
    expectSilent(out_);
    const auto opened = openTooth(out_ / "cut.tactooth");
    ASSERT_TRUE(opened);
    EXPECT_EQ(opened->provenance.front(), std::pair(std::string("tooth"), std::string("molar.stl")));
    EXPECT_EQ(opened->provenance.at(1), std::pair(std::string("layer pulp"), std::string("pulp.stl")));
}

TEST_F(Privacy, ACaseThatIsCutLeavesItsNameAlone) {
    ranWell({"case", "new", in("jaw.ttcase"), "--from", in("molar.stl")});
    std::filesystem::create_directory(out_);
    ranWell({"cut", "--case", in("jaw.ttcase"), "--tool", in("ball.stl"), "--trajectory", in("way.csv"), "--speed-rpm",
             "200000", "--voxel", "0.1", "--out", out_ / "cut.stl", "--save", out_ / "cut.tactooth"});
    expectSilent(out_);
}

TEST_F(Privacy, WhatEarlierVersionsSavedIsForgottenWhenItIsSavedAgain) {
    const Provenance before = {{"tooth", "/home/anna-miller/a/molar.stl"},
                               {"layer pulp", "../anna-miller/pulp.stl"},
                               {"case", "/home/anna-miller/jaw.ttcase"},
                               {"saved", "2026-01-01T00:00:00Z"},
                               {"command", "tactooth cut --tooth /home/anna-miller/a/molar.stl"},
                               {"case from", "https://example.org/anna"}};
    for (const auto& [what, value] : savedNow(before)) {
        EXPECT_EQ(value.find("anna-miller"), std::string::npos) << what << ": " << value;
        EXPECT_NE(what, "command");
    }
    EXPECT_EQ(savedNow(before).front().second, "molar.stl");
}

}  // namespace
}  // namespace tactooth

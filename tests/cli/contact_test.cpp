// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/motion_files.h"

namespace tactooth {
namespace {

using namespace test;

class ContactCommand : public test::MotionFiles {
protected:
    ProgramRun contact(const std::string& poses) {
        return runTactooth({"contact", "--tooth", plate(), "--tool", ball(), "--poses", poses, "--out", out()});
    }
};

TEST_F(ContactCommand, WritesTheColumnsOfItsContract) {
    const ProgramRun run = contact(trajectory({{0, 0, 0, 1}, {0.001, 0, 0, -0.25}}));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_EQ(table().header, "t,touching,depth,nx,ny,nz,px,py,pz,contacts,micros");
}

TEST_F(ContactCommand, EveryRowIsOnItsOwn) {
    contact(trajectory({{0, 0, 0, 1}, {0.001, 0.3, 0.2, -0.25}, {0.002, 0, 0, 1}}));
    const test::CsvContent csv = table();
    ASSERT_EQ(csv.rows.size(), 3U);
    EXPECT_EQ(csv.at(0, "touching"), 0);
    EXPECT_EQ(csv.at(0, "depth"), 0);
    EXPECT_EQ(csv.at(1, "t"), 0.001);
    EXPECT_EQ(csv.at(1, "touching"), 1);
    EXPECT_NEAR(csv.at(1, "depth"), 0.25, 1e-5);
    EXPECT_NEAR(csv.at(1, "nz"), 1, 1e-6);
    EXPECT_NEAR(csv.at(1, "px"), 0.3, 1e-5);
    EXPECT_NEAR(csv.at(1, "pz"), -0.25, 1e-5);
    EXPECT_GE(csv.at(1, "contacts"), 1);
    EXPECT_GT(csv.at(1, "micros"), 0);
    EXPECT_EQ(csv.at(2, "touching"), 0);
}

TEST_F(ContactCommand, RefusesBadPosesWithOneSentenceAndNoFile) {
    for (const auto& [text, sentence] : badTrajectories()) {
        SCOPED_TRACE(sentence);
        expectRefused(contact(text), sentence);
    }
}

TEST_F(ContactCommand, RefusesMissingAndBadFiles) {
    const std::string good = trajectory({{0, 0, 0, 1}});
    const std::string none = missing();
    expectRefused(contact(none), "missing: there is no such file");
    expectRefused(runTactooth({"contact", "--tooth", none, "--tool", ball(), "--poses", good, "--out", out()}),
                  "missing: there is no such file");
    expectRefused(runTactooth({"contact", "--tooth", plate(), "--tool", good, "--poses", good, "--out", out()}),
                  "not an STL surface");
}

TEST_F(ContactCommand, TakesABurByItsNumber) {
    const std::string bur = file("57.stl");
    ASSERT_EQ(runTactooth({"bur", "57", "--out", bur}).exitCode, 0);
    const std::string poses = trajectory({{0, 0, 0, 1}, {0.001, 0.3, 0.2, -0.25}});
    std::vector<std::vector<double>> depths;
    for (const std::vector<std::string>& named : std::vector<std::vector<std::string>>{
             {"--bur", "57"}, {"--tool", "57"}, {"--tool", "500 314 107 006 010"}, {"--bur", bur}}) {
        const ProgramRun run =
            runTactooth({"contact", "--tooth", plate(), named[0], named[1], "--poses", poses, "--out", out()});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        depths.push_back({table().at(0, "depth"), table().at(1, "depth")});
        EXPECT_NEAR(depths.back()[1], 0.25, 2e-3) << named[1];
    }
    EXPECT_EQ(depths[0], depths[1]);
    EXPECT_EQ(depths[0], depths[2]);
}

TEST_F(ContactCommand, SaysOfANameThatItIsNeitherANumberNorAFile) {
    const std::string good = trajectory({{0, 0, 0, 1}});
    for (const char* const name : {"58b", "round", "0", "500 314 107 006"}) {
        expectRefused(runTactooth({"contact", "--tooth", plate(), "--bur", name, "--poses", good, "--out", out()}),
                      std::string(name) + ": there is neither a bur of this number nor a file of this name");
    }
}

TEST_F(ContactCommand, NeedsAllOfItsOptions) {
    const ProgramRun run = runTactooth({"contact", "--tooth", plate()});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("--"));
}

}  // namespace
}  // namespace tactooth

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

TEST_F(ContactCommand, NeedsAllOfItsOptions) {
    const ProgramRun run = runTactooth({"contact", "--tooth", plate()});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("--"));
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_test.h"
#include "geometry/io/stl_reader.h"
#include "geometry/mesh/mesh_report.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;

TEST(BurCommand, WritesAClosedBur) {
    const test::TemporaryFolder folder;
    const std::string out = folder / "330.stl";
    const ProgramRun run = runTactooth({"bur", "330", "--out", out, "--triangles", "5000"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Pear carbide No. 330, 0.8 mm (ISO 500 314 232 006 008), head 0.80 x 1.60 mm"));
    const MeshReport report = reportOn(readStl(out).value());
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.triangles, 5000U);
}

TEST(BurCommand, TakesAnIsoNumber) {
    const test::TemporaryFolder folder;
    const ProgramRun run = runTactooth({"bur", "806 314 001 534 014", "--out", folder / "d.stl"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("801-014"));
}

TEST(BurCommand, ListsEveryBur) {
    const ProgramRun run = runTactooth({"bur", "--list"});
    EXPECT_EQ(run.exitCode, 0);
    for (const char* const number : {"33-1/2", "245", "557", "7901", "909-040", "806 314 198 524 016"}) {
        EXPECT_THAT(run.out, HasSubstr(number));
    }
}

TEST(BurCommand, RefusesAnUnknownNumberAndNamesTheList) {
    const ProgramRun run = runTactooth({"bur", "99", "--out", "x.stl"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("no bur '99'; 'tactooth bur --list'"));
}

TEST(InstrumentCommand, WritesClosedInstruments) {
    const test::TemporaryFolder folder;
    for (const char* const name : {"contra-angle", "low-speed", "mirror-24", "explorer", "probe"}) {
        const std::string out = folder / "i.stl";
        EXPECT_EQ(runTactooth({"instrument", name, "--out", out}).exitCode, 0) << name;
        EXPECT_TRUE(reportOn(readStl(out).value()).watertight()) << name;
    }
    EXPECT_EQ(runTactooth({"instrument", "hammer", "--out", "x.stl"}).exitCode, 2);
}

}  // namespace
}  // namespace tactooth

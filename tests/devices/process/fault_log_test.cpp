// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/fault_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <thread>

#include "geometry/files/file_bytes.h"
#include "support/scoped_variable.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const auto kTime = std::chrono::sys_days(std::chrono::year(2026) / 11 / 27) + 7h + 8min + 22s + 123ms;

std::string textOf(const fs::path& file) { return std::string(readFile(file).value().text()); }

TEST(FaultLog, IsACsvFileThatTheProgramReadsBack) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "new" / "hand-faults.csv";
    EXPECT_TRUE(readFaults(file, 10).empty());
    ASSERT_TRUE(appendFault(file, {kTime, HandFault::NoForce, "Touch, \"left\"\n", 1.834, 0.00213}));
    ASSERT_TRUE(appendFault(file, {kTime + 1s, HandFault::HandKilled, "Haply Inverse3 049D", 0, 0}));
    EXPECT_EQ(textOf(file),
              "time,cause,device,force_n,zero_ms\n"
              "2026-11-27T07:08:22.123Z,no_force,Touch   left  ,1.83,2.1\n"
              "2026-11-27T07:08:23.123Z,hand_killed,Haply Inverse3 049D,0,0\n");
    const auto records = readFaults(file, 10);
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[0].time, kTime);
    EXPECT_EQ(records[0].cause, HandFault::NoForce);
    EXPECT_NEAR(records[0].force, 1.83, 1e-9);
    EXPECT_NEAR(records[0].toZero, 0.0021, 1e-9);
    EXPECT_EQ(records[1].device, "Haply Inverse3 049D");
    EXPECT_EQ(faultTimeText(records[1].time), "2026-11-27 07:08:23 UTC");
    ASSERT_EQ(readFaults(file, 1).size(), 1U);
    EXPECT_EQ(readFaults(file, 1)[0].cause, HandFault::HandKilled) << "the newest";
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(FaultLog, NamesEachCauseOnce) {
    std::set<std::string_view> names, texts;
    for (std::uint32_t i = 0; i <= static_cast<std::uint32_t>(HandFault::HandEnded); ++i) {
        const auto fault = static_cast<HandFault>(i);
        names.insert(nameOf(fault));
        texts.insert(textOf(fault).english);
        EXPECT_EQ(findHandFault(nameOf(fault)), fault);
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(HandFault::HandEnded) + 1);
    EXPECT_EQ(texts.size(), names.size());
    EXPECT_EQ(nameOf(static_cast<HandFault>(4711)), "none");
    EXPECT_FALSE(findHandFault("never heard"));
}

TEST(FaultLog, StaysSmallAndKeepsTheNewest) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "log.csv";
    for (int i = 0; i < 4000; ++i) {
        ASSERT_TRUE(appendFault(file, {kTime + std::chrono::seconds(i), HandFault::NoForce, "pen", 1, 0.001}));
        if (i % 100 == 0) {
            EXPECT_LE(fs::file_size(file), kMaxFaultLogBytes);
        }
    }
    const std::string text = textOf(file);
    EXPECT_THAT(text, StartsWith("time,cause"));
    EXPECT_EQ(text.find("time,cause", 1), text.npos);
    const auto records = readFaults(file, 100'000);
    EXPECT_GT(records.size(), 500U);
    EXPECT_EQ(records.back().time, kTime + 3999s);
    for (std::size_t i = 1; i < records.size(); ++i) EXPECT_EQ(records[i].time - records[i - 1].time, 1s);
}

TEST(FaultLog, SeveralWritersLoseNoLine) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "log.csv";
    {
        std::vector<std::jthread> writers;
        for (int writer = 0; writer < 4; ++writer) {
            writers.emplace_back([&file, writer] {
                for (int i = 0; i < 50; ++i) {
                    appendFault(file, {kTime, HandFault::NoForce, std::to_string(100 * writer + i), 1, 0});
                }
            });
        }
    }
    std::set<std::string> devices;
    for (const FaultRecord& record : readFaults(file, 1000)) devices.insert(record.device);
    EXPECT_EQ(devices.size(), 200U);
}

TEST(FaultLog, LinesThatAreNoneAreLeftOut) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "log.csv";
    test::writeText(file,
                    "time,cause,device,force_n,zero_ms\n"
                    "2026-11-27T07:08:22.123Z,no_force,pen,1,2\n"
                    "2026-13-27T07:08:22.123Z,no_force,pen,1,2\n"
                    "2026-11-27T07:08:22.123Z,something,pen,1,2\n"
                    "2026-11-27T07:08:22.123Z,no_force,pen,nan,2\n"
                    "2026-11-27T07:08:22.123Z,no_force,pen,1\n"
                    "2026-11-27T07:08:22.123Z,no_force,pen,1,2,3\n"
                    "\n,,,,\nnonsense\n2026-11-27T07:08:22.123Z,not_a_number,pen,1,2");
    ASSERT_EQ(readFaults(file, 100).size(), 2U);
    EXPECT_EQ(readFaults(file, 100)[1].cause, HandFault::NotANumber);
}

TEST(FaultLog, AFileThatCannotBeWrittenIsLeftAlone) {
    const test::TemporaryFolder folder;
    const FaultRecord record{kTime, HandFault::NoForce, "pen", 1, 0.001};
    EXPECT_FALSE(appendFault({}, record));
    EXPECT_FALSE(appendFault(folder.path(), record)) << "a folder";
    fs::create_symlink(folder / "elsewhere.csv", folder / "link.csv");
    EXPECT_FALSE(appendFault(folder / "link.csv", record));
    EXPECT_FALSE(fs::exists(folder / "elsewhere.csv"));
}

TEST(FaultLog, StandsInTheUsersStateFolder) {
    const test::ScopedVariable home("HOME", "/home/someone");
    {
        const test::ScopedVariable state("XDG_STATE_HOME", "/var/state");
        EXPECT_EQ(faultLogFile(), "/var/state/tactooth/hand-faults.csv");
    }
    const test::ScopedVariable relative("XDG_STATE_HOME", "state");
    EXPECT_EQ(faultLogFile(), "/home/someone/.local/state/tactooth/hand-faults.csv");
    const test::ScopedVariable nobody("HOME", std::nullopt);
    EXPECT_EQ(faultLogFile(), "");
}

}  // namespace
}  // namespace tactooth

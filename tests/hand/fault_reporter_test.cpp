// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "hand/fault_reporter.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "devices/base/monotonic_clock.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;

class FaultReporterTest : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<FaultRecord> records() const { return readFaults(file_, 100); }

    test::TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "log.csv";
    FaultReporter reporter_{file_, "pen"};
    double now_ = monotonicSeconds();
};

TEST_F(FaultReporterTest, WritesANonsenseForceAtOnceWithItsTime) {
    reporter_.add({HandFault::NotANumber, now_ - 5, 1.5, 0.002});
    ASSERT_EQ(records().size(), 1U);
    EXPECT_EQ(records()[0].cause, HandFault::NotANumber);
    EXPECT_EQ(records()[0].device, "pen");
    EXPECT_NEAR(records()[0].force, 1.5, 1e-9);
    EXPECT_NEAR(records()[0].toZero, 0.002, 1e-9);
    EXPECT_NEAR(std::chrono::duration<double>(std::chrono::system_clock::now() - records()[0].time).count(), 5, 1);
}

TEST_F(FaultReporterTest, SaysWhyNoForceCame) {
    const ForceCut cut{HandFault::NoForce, now_, 1, 0.002};
    reporter_.add(cut);
    reporter_.step(now_ + 0.01, ProgramState::Runs);
    EXPECT_TRUE(records().empty()) << "a moment later it may be known";
    reporter_.step(now_ + 0.02, ProgramState::Stopped);
    ASSERT_EQ(records().size(), 1U);
    EXPECT_EQ(records()[0].cause, HandFault::ProgramStopped);
    reporter_.add(cut);
    reporter_.step(now_ + 0.02, ProgramState::Gone);
    EXPECT_EQ(records()[1].cause, HandFault::ProgramEnded);
    reporter_.add(cut);
    reporter_.step(now_ + 1.1, ProgramState::Runs);
    EXPECT_EQ(records()[2].cause, HandFault::NoForce) << "it hangs or is late";
    reporter_.step(now_ + 2, ProgramState::Gone);
    EXPECT_EQ(records().size(), 3U);
}

TEST_F(FaultReporterTest, OneEndIsOneLine) {
    reporter_.add({HandFault::NoForce, now_, 2, 0.002});
    reporter_.add({HandFault::ProgramEnded, now_ + 0.01, 0, 0, true});
    reporter_.finish(ProgramState::Gone);
    ASSERT_EQ(records().size(), 1U);
    EXPECT_EQ(records()[0].cause, HandFault::ProgramEnded);
    EXPECT_NEAR(records()[0].force, 2, 1e-9);
}

TEST_F(FaultReporterTest, AnEndAfterTheForceCameBackIsALineOfItsOwn) {
    reporter_.add({HandFault::NoForce, now_ - 0.5, 2, 0.002});
    reporter_.add({HandFault::ProgramEnded, now_, 1, 0.002});
    reporter_.finish(ProgramState::Gone);
    ASSERT_EQ(records().size(), 2U);
    EXPECT_EQ(records()[0].cause, HandFault::NoForce);
    EXPECT_EQ(records()[1].cause, HandFault::ProgramEnded);
    EXPECT_NEAR(records()[1].force, 1, 1e-9);
}

TEST(StateOfProcess, IsThatOfTheSystem) {
    EXPECT_EQ(stateOfProcess(getpid()), ProgramState::Runs);
    const pid_t child = fork();
    if (child == 0) {
        for (;;) pause();
    }
    const auto becomes = [child](ProgramState state) {
        for (int i = 0; i < 5000 && stateOfProcess(child) != state; ++i) std::this_thread::sleep_for(1ms);
        return stateOfProcess(child) == state;
    };
    kill(child, SIGSTOP);
    EXPECT_TRUE(becomes(ProgramState::Stopped));
    kill(child, SIGKILL);
    EXPECT_TRUE(becomes(ProgramState::Gone)) << "a zombie has ended";
    waitpid(child, nullptr, 0);
    EXPECT_EQ(stateOfProcess(child), ProgramState::Gone);
}

}  // namespace
}  // namespace tactooth

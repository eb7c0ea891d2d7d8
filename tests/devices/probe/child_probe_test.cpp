// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/probe/child_probe.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "devices/openhaptics/hd_library.h"
#include "support/scoped_variable.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

constexpr double kLong = 60;  // s: only a broken program needs so long

TEST(ChildProbe, BringsTheAnswerHomeHoweverLong) {
    const std::string text(1'000'000, 'x');
    EXPECT_EQ(inChildProcess([&] { return text; }, kLong).value(), text);
    EXPECT_EQ(inChildProcess([] { return std::string(); }, kLong).value(), "");
}

TEST(ChildProbe, ACrashStaysInTheChild) {
    const auto answer = inChildProcess(
        []() -> std::string {
            std::raise(SIGSEGV);
            return "not reached";
        },
        kLong);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message(), HasSubstr("it crashes"));
}

TEST(ChildProbe, AnExitIsNoAnswer) {
    const auto answer = inChildProcess([]() -> std::string { std::_Exit(3); }, kLong);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message(), HasSubstr("ends the program"));
}

TEST(ChildProbe, AnExitThatReportsSuccessIsNoAnswerEither) {
    for (const auto& end : {+[] { std::exit(0); }, +[] { std::_Exit(0); }, +[] { std::quick_exit(0); }}) {
        const auto answer = inChildProcess(
            [end]() -> std::string {
                end();
                return "not reached";
            },
            kLong);
        ASSERT_FALSE(answer);
        EXPECT_THAT(answer.error().message(), HasSubstr("ends the program"));
    }
}

TEST(ChildProbe, AnExceptionEndsTheChildAndDoesNotRunTheProgramOnInIt) {
    const auto answer = inChildProcess([]() -> std::string { throw std::runtime_error("no licence"); }, kLong);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message(), HasSubstr("it crashes"));
}

TEST(ChildProbe, SignalsThatTheProgramBlocksOrCatchesEndTheChild) {
    sigset_t blocked, before;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &blocked, &before);
    const auto answer = inChildProcess(
        []() -> std::string {
            std::raise(SIGTERM);
            return "not reached";
        },
        kLong);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message(), HasSubstr("it crashes"));
}

TEST(ChildProbe, WhatTheChildHasLeftBehindIsEndedAndNotWaitedFor) {
    const auto start = std::chrono::steady_clock::now();
    const auto answer = inChildProcess(
        [] {
            const pid_t left = fork();
            if (left == 0) {
                std::this_thread::sleep_for(std::chrono::hours(1));
                _exit(0);
            }
            return std::to_string(left);
        },
        2 * kLong);
    ASSERT_TRUE(answer) << answer.error().message();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::duration<double>(kLong));
    const pid_t left = std::stoi(*answer);
    const auto isGone = [left] {
        return kill(left, 0) != 0 || access(("/proc/" + std::to_string(left) + "/exe").c_str(), R_OK) != 0;
    };
    for (int i = 0; i < 1000 * kLong && !isGone(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_TRUE(isGone());
}

struct Ending {
    const char* how;
    const char* words;  ///< expected in the message; none: the library works
    double seconds;     ///< time limit, s
};

class LibraryEndings : public ::testing::TestWithParam<Ending> {};

TEST_P(LibraryEndings, OfAConstructorAreReportedAsWhatTheyAre) {
    const test::ScopedVariable how("TACTOOTH_TEST_ENDING", std::string(GetParam().how));
    const auto answer = inChildProcess(
        [] { return std::string(dlopen(TACTOOTH_ENDING_HD, RTLD_NOW) != nullptr ? "loaded" : "not loaded"); },
        GetParam().seconds);
    if (GetParam().words == nullptr) {
        ASSERT_TRUE(answer) << answer.error().message();
        EXPECT_EQ(*answer, "loaded");
    } else {
        ASSERT_FALSE(answer) << *answer;
        EXPECT_THAT(answer.error().message(), HasSubstr(GetParam().words));
    }
}

constexpr const char* kEnds = "it ends the program";
constexpr const char* kCrashes = "it crashes";
constexpr const char* kHangs = "it does not return";
constexpr const char* kCloses = "it closes what it has not opened";
constexpr double kShort = 0.3;  // s

INSTANTIATE_TEST_SUITE_P(All, LibraryEndings,
                         ::testing::Values(Ending{"exit", kEnds, kLong}, Ending{"exit at exit", kEnds, kLong},
                                           Ending{"_exit", kEnds, kLong}, Ending{"quick_exit", kEnds, kLong},
                                           Ending{"abort", kCrashes, kLong}, Ending{"throw", kCrashes, kLong},
                                           Ending{"terminate", kCrashes, kLong}, Ending{"kill", kCrashes, kLong},
                                           Ending{"hang", kHangs, kShort}, Ending{"stop", kHangs, kShort},
                                           Ending{"close", kCloses, kLong}, Ending{"close and hang", kHangs, kShort},
                                           Ending{"close and exit", kEnds, kLong}, Ending{"say ok", kEnds, kLong},
                                           Ending{"leave a process", nullptr, kLong},
                                           Ending{"leave a process and exit", kHangs, kShort},
                                           Ending{"none", nullptr, kLong}),
                         [](const auto& one) {
                             std::string name = one.param.how;
                             std::ranges::replace(name, ' ', '_');
                             return name;
                         });

TEST(LibraryProbe, ALibraryThatExitsWhileItIsLoadedIsRefusedWithASentence) {
    const test::ScopedVariable how("TACTOOTH_TEST_ENDING", "exit");
    const auto tried = HdLibrary::probeLibrary(TACTOOTH_ENDING_HD);
    ASSERT_FALSE(tried);
    EXPECT_EQ(tried.error().message(), TACTOOTH_ENDING_HD
              " is broken, it ends the program that uses it: install the device's driver anew; Tactooth leaves it "
              "alone.");
}

TEST(ChildProbe, AChildThatHangsIsGivenUp) {
    const auto start = std::chrono::steady_clock::now();
    const auto answer = inChildProcess(
        [] {
            std::this_thread::sleep_for(std::chrono::hours(1));
            return std::string();
        },
        0.2);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message(), HasSubstr("does not return"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::duration<double>(kLong));
}

}  // namespace
}  // namespace tactooth

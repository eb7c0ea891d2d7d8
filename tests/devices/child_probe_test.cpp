// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/child_probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

namespace tactooth {
namespace {

using ::testing::HasSubstr;

TEST(ChildProbe, BringsTheAnswerHomeHoweverLong) {
    const std::string text(1'000'000, 'x');
    EXPECT_EQ(inChildProcess([&] { return text; }, 20).value(), text);
    EXPECT_EQ(inChildProcess([] { return std::string(); }, 20).value(), "");
}

TEST(ChildProbe, ACrashStaysInTheChild) {
    const auto answer = inChildProcess(
        []() -> std::string {
            std::raise(SIGSEGV);
            return "not reached";
        },
        20);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message, HasSubstr("it crashes"));
}

TEST(ChildProbe, AnExitIsNoAnswer) {
    const auto answer = inChildProcess([]() -> std::string { std::_Exit(3); }, 20);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message, HasSubstr("ends the program"));
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
    EXPECT_THAT(answer.error().message, HasSubstr("does not return"));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace tactooth

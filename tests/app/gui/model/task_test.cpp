// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/task.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace tactooth {
namespace {

Expected<int> resultOf(Task<int>& task) {
    for (;;) {
        if (auto result = task.poll()) return *result;
        std::this_thread::yield();
    }
}

TEST(Task, DeliversOnce) {
    Task<int> task;
    task.start([] { return Expected<int>(7); });
    EXPECT_EQ(resultOf(task).value(), 7);
    EXPECT_FALSE(task.isBusy());
    EXPECT_FALSE(task.poll().has_value());
}

TEST(Task, DeliversTheReasonOfAFailure) {
    Task<int> task;
    task.start([]() -> Expected<int> { return unexpected(Message::verbatim("no.")); });
    EXPECT_EQ(resultOf(task).error().message(), "no.");
}

TEST(Task, OfTasksDuringTheWorkOnlyTheLastCounts) {
    Task<int> task;
    std::atomic<bool> go{false};
    std::atomic<int> done{0};
    task.start([&]() -> Expected<int> {
        while (!go) std::this_thread::yield();
        return ++done, 1;
    });
    task.start([&]() -> Expected<int> { return ++done, 2; });
    task.start([&]() -> Expected<int> { return ++done, 3; });
    go = true;
    EXPECT_EQ(resultOf(task).value(), 3);
    EXPECT_EQ(done, 2);
}

TEST(Task, WhatWasCancelledIsNotDelivered) {
    Task<int> task;
    task.start([] { return Expected<int>(1); });
    task.cancel();
    while (task.isBusy()) EXPECT_FALSE(task.poll().has_value());
    EXPECT_FALSE(task.poll().has_value());
}

TEST(Task, CancellingDropsTheTaskThatWaitsToo) {
    Task<int> task;
    std::atomic<bool> go{false}, second{false};
    task.start([&]() -> Expected<int> {
        while (!go) std::this_thread::yield();
        return 1;
    });
    task.start([&]() -> Expected<int> { return second = true, 2; });
    task.cancel();
    go = true;
    while (task.isBusy()) EXPECT_FALSE(task.poll().has_value());
    EXPECT_FALSE(second);
}

TEST(Task, CancellingWhenNothingRunsDoesNotSwallowTheNextResult) {
    Task<int> task;
    task.cancel();
    task.start([] { return Expected<int>(3); });
    EXPECT_EQ(resultOf(task).value(), 3);
}

TEST(Task, ATaskAfterCancellingIsDelivered) {
    Task<int> task;
    task.start([] { return Expected<int>(1); });
    task.cancel();
    task.start([] { return Expected<int>(2); });
    EXPECT_EQ(resultOf(task).value(), 2);
}

}  // namespace
}  // namespace tactooth

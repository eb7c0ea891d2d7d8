// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/task.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <new>
#include <thread>
#include <vector>

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

TEST(Task, CancellingWhenNothingRunsDoesNotDropTheNextResult) {
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

TEST(Task, AnExecutorDecidesWhenTheWorkRuns) {
    std::vector<std::function<void()>> waiting;
    Task<int> task([&](std::function<void()> work) {
        waiting.push_back(std::move(work));
        return std::jthread();
    });
    task.start([] { return Expected<int>(5); });
    EXPECT_TRUE(task.isBusy());
    EXPECT_FALSE(task.poll().has_value());
    waiting.front()();
    EXPECT_EQ(task.poll().value().value(), 5);
}

TEST(Task, WorkThatRunsAtOnceIsDeliveredAtTheNextPoll) {
    Task<int> task([](const std::function<void()>& work) {
        work();
        return std::jthread();
    });
    task.start([] { return Expected<int>(8); });
    EXPECT_TRUE(task.isBusy());
    EXPECT_EQ(task.poll().value().value(), 8);
}

TEST(Task, TheDestructorWaitsForTheWork) {
    std::atomic<bool> started{false}, done{false};
    {
        Task<int> task;
        task.start([&]() -> Expected<int> {
            started = true;
            for (int i = 0; i < 100; ++i) std::this_thread::yield();
            done = true;
            return 1;
        });
        while (!started) std::this_thread::yield();
    }
    EXPECT_TRUE(done);
}

TEST(Task, AResultThatCannotBeCopiedIsMoved) {
    Task<std::unique_ptr<int>> task;
    task.start([] { return Expected<std::unique_ptr<int>>(std::make_unique<int>(4)); });
    for (;;) {
        if (auto result = task.poll()) {
            EXPECT_EQ(**result.value(), 4);
            break;
        }
        std::this_thread::yield();
    }
}

TEST(Task, AnExceptionOfTheWorkReachesThePoll) {
    Task<int> task([](const std::function<void()>& work) {
        work();
        return std::jthread();
    });
    task.start([]() -> Expected<int> { throw std::bad_alloc(); });
    EXPECT_THROW((void)task.poll(), std::bad_alloc);
    EXPECT_FALSE(task.isBusy());
}

}  // namespace
}  // namespace tactooth

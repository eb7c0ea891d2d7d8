// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/errand.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace tactooth {
namespace {

Expected<int> resultOf(Errand<int>& errand) {
    for (;;) {
        if (auto result = errand.poll()) return *result;
        std::this_thread::yield();
    }
}

TEST(Errand, DeliversOnce) {
    Errand<int> errand;
    errand.start([] { return Expected<int>(7); });
    EXPECT_EQ(resultOf(errand).value(), 7);
    EXPECT_FALSE(errand.isBusy());
    EXPECT_FALSE(errand.poll().has_value());
}

TEST(Errand, DeliversTheReasonOfAFailure) {
    Errand<int> errand;
    errand.start([]() -> Expected<int> { return unexpected("no."); });
    EXPECT_EQ(resultOf(errand).error().message, "no.");
}

TEST(Errand, OfWishesDuringTheWorkOnlyTheLastCounts) {
    Errand<int> errand;
    std::atomic<bool> go{false};
    std::atomic<int> done{0};
    errand.start([&]() -> Expected<int> {
        while (!go) std::this_thread::yield();
        return ++done, 1;
    });
    errand.start([&]() -> Expected<int> { return ++done, 2; });
    errand.start([&]() -> Expected<int> { return ++done, 3; });
    go = true;
    EXPECT_EQ(resultOf(errand).value(), 3);
    EXPECT_EQ(done, 2);
}

TEST(Errand, WhatWasForgottenIsNotDelivered) {
    Errand<int> errand;
    errand.start([] { return Expected<int>(1); });
    errand.forget();
    while (errand.isBusy()) EXPECT_FALSE(errand.poll().has_value());
    EXPECT_FALSE(errand.poll().has_value());
}

TEST(Errand, ForgettingDropsTheWishThatWaitsToo) {
    Errand<int> errand;
    std::atomic<bool> go{false}, second{false};
    errand.start([&]() -> Expected<int> {
        while (!go) std::this_thread::yield();
        return 1;
    });
    errand.start([&]() -> Expected<int> { return second = true, 2; });
    errand.forget();
    go = true;
    while (errand.isBusy()) EXPECT_FALSE(errand.poll().has_value());
    EXPECT_FALSE(second);
}

TEST(Errand, ForgettingWhenNothingRunsDoesNotSwallowTheNextResult) {
    Errand<int> errand;
    errand.forget();
    errand.start([] { return Expected<int>(3); });
    EXPECT_EQ(resultOf(errand).value(), 3);
}

TEST(Errand, AWishAfterForgettingIsDelivered) {
    Errand<int> errand;
    errand.start([] { return Expected<int>(1); });
    errand.forget();
    errand.start([] { return Expected<int>(2); });
    EXPECT_EQ(resultOf(errand).value(), 2);
}

}  // namespace
}  // namespace tactooth

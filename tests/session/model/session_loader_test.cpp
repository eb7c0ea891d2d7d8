// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_loader.h"

#include <gtest/gtest.h>

#include "model/model_scene.h"

namespace tactooth {
namespace {

class SessionLoaderTest : public testing::Test {
protected:
    test::SpySound sound_;
    SessionModel model_{sound_, test::runInline};
    test::ManualExecutor later_;
    SessionLoader loader_{model_, later_.executor()};
};

TEST_F(SessionLoaderTest, InstallsAToothOnceItIsMade) {
    loader_.load([] { return Expected<SessionTooth>(test::blockTooth()); });
    EXPECT_TRUE(loader_.isBusy());
    EXPECT_FALSE(loader_.poll());
    EXPECT_FALSE(model_.tooth());
    later_.runNext();
    EXPECT_FALSE(loader_.poll());
    EXPECT_FALSE(loader_.isBusy());
    ASSERT_TRUE(model_.tooth());
    EXPECT_EQ(model_.tooth()->name, "Block");
}

TEST_F(SessionLoaderTest, LoadsToothAndBurAtTheSameTime) {
    loader_.load([] { return Expected<SessionTooth>(test::blockTooth()); });
    loader_.load([] { return Expected<SessionBur>(test::flatSessionBur()); });
    EXPECT_EQ(later_.waiting(), 2U);
    later_.runNext();
    later_.runNext();
    EXPECT_FALSE(loader_.poll());
    EXPECT_TRUE(model_.tooth() && model_.bur());
}

TEST_F(SessionLoaderTest, WhatIsCancelledIsNotInstalledButTheNextOneIs) {
    loader_.load([] { return Expected<SessionTooth>(test::blockTooth()); });
    loader_.cancel();
    EXPECT_FALSE(loader_.isBusy());
    SessionTooth next = test::blockTooth();
    next.name = "Next";
    loader_.load([next] { return Expected<SessionTooth>(next); });
    EXPECT_TRUE(loader_.isBusy());
    later_.runNext();
    EXPECT_FALSE(loader_.poll());
    EXPECT_FALSE(model_.tooth());
    EXPECT_TRUE(loader_.isBusy());
    later_.runNext();
    EXPECT_FALSE(loader_.poll());
    ASSERT_TRUE(model_.tooth());
    EXPECT_EQ(model_.tooth()->name, "Next");
    EXPECT_FALSE(loader_.isBusy());
}

TEST_F(SessionLoaderTest, AFailureIsReportedOnceAndKeepsTheTooth) {
    model_.install(test::blockTooth());
    loader_.load([]() -> Expected<SessionTooth> { return unexpected(Message::verbatim("no such file.")); });
    later_.runNext();
    const auto failure = loader_.poll();
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->message(), "no such file.");
    EXPECT_FALSE(loader_.poll());
    EXPECT_EQ(model_.tooth()->name, "Block");
}

TEST_F(SessionLoaderTest, AFailingBurKeepsTheBur) {
    model_.install(test::flatSessionBur());
    loader_.load([]() -> Expected<SessionBur> { return unexpected(Message::verbatim("no bur.")); });
    later_.runNext();
    EXPECT_EQ(loader_.poll().value().message(), "no bur.");
    EXPECT_EQ(model_.bur()->name, "Flat");
}

TEST_F(SessionLoaderTest, OfTeethThatAreAskedForMeanwhileTheLastIsInstalled) {
    for (const char* const name : {"first", "second", "third"}) {
        loader_.load([name] {
            SessionTooth tooth = test::blockTooth();
            tooth.name = name;
            return Expected<SessionTooth>(std::move(tooth));
        });
    }
    ASSERT_EQ(later_.waiting(), 1U);
    later_.runNext();
    EXPECT_FALSE(loader_.poll());
    EXPECT_FALSE(model_.tooth()) << "another one is wanted by now";
    later_.runNext();
    EXPECT_FALSE(loader_.poll());
    ASSERT_TRUE(model_.tooth());
    EXPECT_EQ(model_.tooth()->name, "third");
}

}  // namespace
}  // namespace tactooth

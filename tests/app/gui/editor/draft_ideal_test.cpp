// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/draft_ideal.h"

#include <gmock/gmock.h>

#include <deque>

#include "geometry/io/stl_writer.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

/// A block with its top at z = 5 and pulp up to z = 2, and a square of 4 x 3 mm drawn on the top. Work runs when the
/// test says so.
class DraftIdealTest : public testing::Test {
protected:
    void SetUp() override {
        exercise_.bur = std::string("57");  // 1 mm, with a flat end
        exercise_.ideal =
            PreparationPlan{.outward = Vec3::UnitZ(),
                            .depth = 1.5,
                            .isFlat = true,
                            .strokes = {},
                            .fissure = {},
                            .boxes = {},
                            .body = {},
                            .outline = DrawnOutline{.corners = {{-2, -1.5, 5}, {2, -1.5, 5}, {2, 1.5, 5}, {-2, 1.5, 5}},
                                                    .burRadius = 0.5,
                                                    .burLength = 4.2}};
    }
    PreparationPlan& plan() { return std::get<PreparationPlan>(exercise_.ideal); }
    void runOldest() {
        const auto work = std::move(waiting_.front());
        waiting_.pop_front();
        work();
    }

    std::shared_ptr<const LayeredTooth> tooth_ = std::make_shared<const LayeredTooth>(
        *LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5)),
                            std::vector<LayerMesh>{{"pulp", test::kPulp, test::box(Vec3(-1, -1, -3), Vec3(1, 1, 2))}}));
    Exercise exercise_;
    std::deque<std::function<void()>> waiting_;
    DraftIdeal ideal_{[this](std::function<void()> work) {
        waiting_.push_back(std::move(work));
        return std::jthread();
    }};
};

TEST_F(DraftIdealTest, MakesTheGhostAndItsDistanceFromThePulp) {
    EXPECT_FALSE(ideal_.isPreparing());
    ideal_.follow(exercise_, tooth_);
    EXPECT_TRUE(ideal_.isPreparing());
    EXPECT_EQ(ideal_.share(), 0);
    EXPECT_FALSE(ideal_.poll());
    EXPECT_FALSE(ideal_.cavity());
    runOldest();
    EXPECT_GT(ideal_.share(), 0.5);
    EXPECT_LE(ideal_.share(), 1);
    EXPECT_TRUE(ideal_.poll());
    EXPECT_FALSE(ideal_.isPreparing());
    ASSERT_TRUE(ideal_.cavity());
    EXPECT_FALSE(ideal_.cavity()->ghost->empty());
    EXPECT_NEAR(*ideal_.cavity()->toPulp, 5 - 1.5 - 2, 0.01);
}

TEST_F(DraftIdealTest, DropsWhatIsOutOfDateAtOnce) {
    ideal_.follow(exercise_, tooth_);
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    plan().depth = 2;
    EXPECT_FALSE(ideal_.isOf(exercise_, tooth_));
    ideal_.follow(exercise_, tooth_);
    EXPECT_FALSE(ideal_.cavity());
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    EXPECT_NEAR(*ideal_.cavity()->toPulp, 5 - 2 - 2, 0.01);
}

TEST_F(DraftIdealTest, EndsTheWorkThatNobodyWantsAndBeginsAnew) {
    ideal_.follow(exercise_, tooth_);
    plan().depth = 2;
    ideal_.follow(exercise_, tooth_);
    EXPECT_EQ(waiting_.size(), 1U) << "one piece of work at a time";
    runOldest();
    EXPECT_EQ(ideal_.share(), 0);
    EXPECT_FALSE(ideal_.poll()) << "the first cavity comes never";
    EXPECT_TRUE(ideal_.isPreparing());
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    EXPECT_NEAR(*ideal_.cavity()->toPulp, 5 - 2 - 2, 0.01);
    EXPECT_TRUE(waiting_.empty());
}

TEST_F(DraftIdealTest, IsNotMadeAnewForWhatItDoesNotFollowFrom) {
    ideal_.follow(exercise_, tooth_);
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    exercise_.name = "Box";
    exercise_.minutes = 3;
    ideal_.follow(exercise_, tooth_);
    EXPECT_TRUE(ideal_.cavity());
    EXPECT_FALSE(ideal_.isPreparing());
    exercise_.bur = std::string("330");
    ideal_.follow(exercise_, tooth_);
    EXPECT_TRUE(ideal_.isPreparing());
    EXPECT_FALSE(ideal_.cavity());
}

TEST_F(DraftIdealTest, AnotherToothBringsAnotherCavity) {
    ideal_.follow(exercise_, tooth_);
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    const auto solid =
        std::make_shared<const LayeredTooth>(*LayeredTooth::make(test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5))));
    ideal_.follow(exercise_, solid);
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    EXPECT_FALSE(ideal_.cavity()->toPulp) << "it has no pulp";
}

TEST_F(DraftIdealTest, SaysInOneSentenceWhyThereIsNone) {
    for (Vec3& corner : plan().outline->corners) corner.x() += 20;
    exercise_.file = "/somewhere/draft.toml";
    ideal_.follow(exercise_, tooth_);
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    EXPECT_FALSE(ideal_.cavity());
    ASSERT_TRUE(ideal_.fault());
    EXPECT_EQ(ideal_.fault()->in(Language::English),
              "The ideal cavity cannot be made: the outline is narrower than the bur, lies beside the tooth, or does "
              "not reach its box; draw it anew.");
    EXPECT_THAT(ideal_.fault()->in(Language::Japanese), testing::StartsWith("理想窩洞を作れません。外形が"));
    for (Vec3& corner : plan().outline->corners) corner.x() -= 20;
    ideal_.follow(exercise_, tooth_);
    EXPECT_FALSE(ideal_.fault());
}

TEST_F(DraftIdealTest, AnIdealThatTakesNothingAwayIsNoCavity) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeStl(tooth_->ownOuter()->mesh(), folder / "uncut.stl"));
    exercise_.ideal = folder / "uncut.stl";
    ideal_.follow(exercise_, tooth_);
    runOldest();
    EXPECT_TRUE(ideal_.poll());
    ASSERT_TRUE(ideal_.fault());
    EXPECT_EQ(ideal_.fault()->id(), "draft_ideal_empty");
}

TEST_F(DraftIdealTest, NothingComesAfterItWasDropped) {
    ideal_.follow(exercise_, tooth_);
    ideal_.clear();
    EXPECT_FALSE(ideal_.isPreparing());
    EXPECT_FALSE(ideal_.isOf(exercise_, tooth_));
    runOldest();
    EXPECT_FALSE(ideal_.poll());
    EXPECT_FALSE(ideal_.cavity() || ideal_.fault());
}

}  // namespace
}  // namespace tactooth

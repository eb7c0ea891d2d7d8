// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mouse_surroundings.h"

#include <gtest/gtest.h>

#include "session/bench_scene.h"

namespace tactooth {
namespace {

class MouseSurroundingsTest : public testing::Test {
protected:
    [[nodiscard]] const MouseManipulator::Surroundings& known() const { return hand_.surroundings(); }
    void show() { surroundings_.show(hand_, *tooth_, tooth_->surface(), bur_.shape); }

    const std::shared_ptr<CutModel> tooth_ = test::blockOnTheBench();
    Instrument bur_ = test::flatBur();
    MouseManipulator hand_{Box3(Vec3(-2, -2, -3), Vec3(2, 2, 0)), 1};
    MouseSurroundings surroundings_;
};

TEST_F(MouseSurroundingsTest, TheHandKnowsTheToothAndTheTool) {
    EXPECT_EQ(known().touchable, nullptr);
    show();
    ASSERT_NE(known().touchable, nullptr);
    EXPECT_EQ(known().touchable->base, tooth_->surface()->base);
    EXPECT_EQ(known().tool, bur_.shape);
    EXPECT_EQ(known().uncut, tooth_->tooth().ownOuter());
}

TEST_F(MouseSurroundingsTest, ACutIsShownAndTheUncutSurfaceStays) {
    show();
    const auto before = known().touchable;
    show();
    EXPECT_EQ(known().touchable, before) << "nothing has changed";
    tooth_->sweep(bur_.cutting, test::at(0, 0, 0.5), test::at(0, 0, -0.5));
    tooth_->refreshSurface();
    show();
    EXPECT_NE(known().touchable, before);
    EXPECT_EQ(known().uncut, tooth_->tooth().ownOuter());
}

TEST_F(MouseSurroundingsTest, AnotherToolIsShown) {
    show();
    bur_ = test::flatBur();
    show();
    EXPECT_EQ(known().tool, bur_.shape);
}

/// As after a change of hands: the new hand knows nothing yet, though the tooth is the same.
TEST_F(MouseSurroundingsTest, AnotherHandIsShownAllAfterItWasForgotten) {
    show();
    hand_ = MouseManipulator(Box3(Vec3(-2, -2, -3), Vec3(2, 2, 0)), 1);
    show();
    EXPECT_EQ(known().touchable, nullptr);
    surroundings_.forget();
    show();
    EXPECT_NE(known().touchable, nullptr);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/hand_pointer.h"

#include <gtest/gtest.h>

#include "hands/pinhole.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

const Box3 kTooth(Vec3(-5, -5, -10), Vec3(5, 5, 5));

/// A mirror behind the tooth (-y) shows its far side to an eye at +y.
class HandPointerTest : public testing::Test {
protected:
    HandPointerTest() {
        surface_.base = std::make_shared<const SurfacePart>(test::box(kTooth.min(), kTooth.max()));
        const Vec3 side(0, -5, 2), centre(2, -14, 6);
        const Vec3 normal = ((side - centre).normalized() + (picture_.eye() - centre).normalized()).normalized();
        glass_ = {centre, normal, 10};
    }
    [[nodiscard]] HandPointer::Sight sight() const { return {picture_, glass_, surface_}; }
    [[nodiscard]] Vec2 imageOf(const Vec3& place) const { return picture_.pixelOf(mirrorImage(glass_, place)); }

    Surface surface_;
    test::Pinhole picture_{{1.4, 0.7}};
    MirrorDisc glass_;
    MouseManipulator hand_{kTooth, 1};
    HandPointer pointer_;
};

TEST_F(HandPointerTest, ThePlaceThatIsAimedAtThroughTheMirrorIsSeenAtThePixel) {
    int aimed = 0;
    for (double x = -3; x <= 3; x += 0.5) {
        for (double z = -1; z <= 4; z += 0.5) {
            const Vec2 pixel = imageOf(Vec3(x, -5, z));
            pointer_.aim(hand_, sight(), pixel);
            if (!pointer_.isInMirror()) continue;  // the tooth hides this part of the glass
            ASSERT_TRUE(hand_.landing()) << x << ' ' << z;
            EXPECT_LT((*hand_.landing() - Vec3(x, -5, z)).norm(), 1e-9);
            EXPECT_LT((imageOf(*hand_.landing()) - pixel).norm(), 1e-6);
            ++aimed;
        }
    }
    EXPECT_GT(aimed, 60);
}

TEST_F(HandPointerTest, TheBurHoversBeforeTheSideThatTheMirrorShows) {
    hand_.alignShaft(-Vec3::UnitY());
    pointer_.aim(hand_, sight(), imageOf(Vec3(1, -5, 3)));
    ASSERT_TRUE(pointer_.isInMirror());
    EXPECT_NEAR(hand_.pose().position.y(), -6.5, 1e-9) << "1.5 mm before it";
    EXPECT_LT((hand_.pressDirection() - Vec3::UnitY()).norm(), 1e-9) << "away from the glass";
}

TEST_F(HandPointerTest, BesideTheGlassAndWithoutItTheHandPointsAtWhatTheEyeSees) {
    const Vec2 onTop = picture_.pixelOf(Vec3(0, 3, 5));
    pointer_.aim(hand_, sight(), onTop);
    EXPECT_FALSE(pointer_.isInMirror());
    EXPECT_LT((*hand_.landing() - Vec3(0, 3, 5)).norm(), 1e-9);
    const Vec2 inGlass = imageOf(Vec3(1, -5, 3));
    pointer_.aim(hand_, {picture_, {}, surface_}, inGlass);
    EXPECT_FALSE(pointer_.isInMirror());
}

TEST_F(HandPointerTest, APressedTipFollowsThePictureInTheMirror) {
    hand_.setPressMode(PressMode::Force);
    const Vec2 start = imageOf(Vec3(0, -5, 3));
    pointer_.aim(hand_, sight(), start);
    pointer_.press(hand_, sight(), start);
    ASSERT_TRUE(pointer_.isInMirror());
    const Vec3 before = hand_.pose().position;
    Vec2 mouse = start;
    for (const Vec2& step : {Vec2(30, 0), Vec2(0, 20)}) {
        const Vec2 from = imageOf(hand_.pose().position);
        mouse += step;
        pointer_.drag(hand_, sight(), mouse);
        const Vec2 moved = imageOf(hand_.pose().position) - from;
        EXPECT_NEAR(moved.x(), step.x(), 0.15 * step.norm());
        EXPECT_NEAR(moved.y(), step.y(), 0.15 * step.norm());
    }
    EXPECT_GT((hand_.pose().position - before).norm(), 0.5);
}

TEST_F(HandPointerTest, APressInTheMirrorWaitsBesideTheGlassAndADirectOneStaysDirect) {
    hand_.setPressMode(PressMode::Force);
    const Vec2 inGlass = imageOf(Vec3(0, -5, 3));
    pointer_.press(hand_, sight(), inGlass);
    const Vec3 before = hand_.pose().position;
    pointer_.drag(hand_, sight(), inGlass + Vec2(900, 0));
    EXPECT_EQ(hand_.pose().position, before);
    pointer_.drag(hand_, {picture_, {}, surface_}, inGlass + Vec2(5, 0));
    EXPECT_EQ(hand_.pose().position, before) << "the mirror was put away";
    hand_.release();

    const Vec2 onTop = picture_.pixelOf(Vec3(0, 3, 5));
    pointer_.press(hand_, sight(), onTop);
    pointer_.drag(hand_, sight(), inGlass);
    EXPECT_FALSE(pointer_.isInMirror());
    EXPECT_GT((hand_.pose().position - before).norm(), 1);
}

TEST_F(HandPointerTest, ALeanGoesWhereTheMouseGoesInTheMirror) {
    pointer_.aim(hand_, sight(), imageOf(Vec3(0, -5, 3)));
    ASSERT_TRUE(pointer_.isInMirror());
    const auto end = [&]() -> Vec2 { return imageOf(hand_.pose() * Vec3(0, 0, 5)) - imageOf(hand_.pose().position); };
    const Vec2 before = end();
    pointer_.tilt(hand_, sight(), Vec2(40, 0));
    EXPECT_GT((end() - before).x(), 5);
}

}  // namespace
}  // namespace tactooth

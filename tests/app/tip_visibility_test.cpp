// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The bur's head and the place where it lands are visible in every standard view.
#include "app/common/tip_visibility.h"

#include <gtest/gtest.h>

#include "app/tip_visibility_scene.h"

namespace tactooth {
namespace {

using TipVisibilityTest = test::TipVisibilityTest;

TEST_F(TipVisibilityTest, OnSomeTeethInEveryStandardView) {
    for (const int fdi : {46, 11, 24, 33}) expectSeen(fdi, "4");
}

TEST_F(TipVisibilityTest, WithoutGlassTheHandpieceHidesTheTipFromOcclusal) {
    test::ToothToSee tooth = test::toothToSee(46, *findBur("4"));
    const std::vector<test::Aim> aims = test::aimsAt(tooth, StandardView::Occlusal, test::kPicture);
    ASSERT_FALSE(aims.empty());
    Scene scene = test::sceneOf(tooth, aims.front());
    EXPECT_GE(measure(scene).head, test::kSeen);
    for (SceneObject& object : scene.objects) {
        if (object.handle) object.glassAbove.reset();
    }
    const TipVisibility hidden = measure(scene);
    EXPECT_LT(hidden.head, 0.2);
    EXPECT_LT(hidden.landing, 0.5);
}

}  // namespace
}  // namespace tactooth

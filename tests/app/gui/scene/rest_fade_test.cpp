// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/rest_fade.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(RestFade, PassesEvenlyFromTheFirstPictureToTheLastWithinAQuarterOfASecond) {
    EXPECT_EQ(restFadeShare(0), 0);
    EXPECT_LT(restFadeShare(149), 1);
    EXPECT_EQ(restFadeShare(250), 1);
    EXPECT_EQ(restFadeShare(1e9), 1);
    for (int ms = 0; ms < 300; ++ms) {
        EXPECT_GE(restFadeShare(ms + 1), restFadeShare(ms));
        EXPECT_LT(restFadeShare(ms + 1) - restFadeShare(ms), 0.01) << "no jump at " << ms;
    }
}

TEST(RestFade, DrawsNothingBeforeItStartsAndAfterItStops) {
    RestFade fade([] { FAIL() << "nothing is due"; });
    EXPECT_FALSE(fade.isRunning());
    fade.draw(0);  // without any OpenGL context
    fade.stop();
    fade.forget();
    EXPECT_FALSE(fade.isRunning());
}

}  // namespace
}  // namespace tactooth

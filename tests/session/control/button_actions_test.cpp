// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/button_actions.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(ButtonActions, AButtonCountsWhenItGoesDown) {
    ButtonActions actions;
    const ButtonMap map;
    actions.press(0, map);
    for (int i = 0; i < 5; ++i) actions.press(2, map);
    EXPECT_TRUE(actions.cutToggled());
    EXPECT_FALSE(actions.swapToggled());
    actions.press(0, map);
    actions.press(2, map);
    EXPECT_FALSE(actions.cutToggled());
    actions.press(1, map);
    EXPECT_TRUE(actions.swapToggled());
}

TEST(ButtonActions, AButtonThatIsDownFromTheStartDoesNothing) {
    ButtonActions actions;
    const ButtonMap map;
    actions.press(3, map);
    actions.press(3, map);
    EXPECT_FALSE(actions.cutToggled());
    EXPECT_FALSE(actions.swapToggled());
}

TEST(ButtonActions, ButtonsCanBeMappedAnew) {
    ButtonActions actions;
    const ButtonMap map{.swap = ButtonMap::kNone, .cut = 31, .clutch = 2};
    actions.press(0, map);
    actions.press(1U << 31 | 3U, map);
    EXPECT_TRUE(actions.cutToggled());
    EXPECT_FALSE(actions.swapToggled());
    EXPECT_FALSE(actions.clutchHeld());
    actions.press(4, map);
    EXPECT_TRUE(actions.clutchHeld());
    actions.press(0, map);
    EXPECT_FALSE(actions.clutchHeld());
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/window/screen_fit.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

constexpr QMargins kFrame(4, 26, 4, 4);

TEST(ScreenFit, AWindowThatFitsStaysWhereItIs) {
    const QRect window(100, 80, 800, 600);
    EXPECT_EQ(fittedInto({0, 0, 1400, 900}, window, kFrame), window);
}

TEST(ScreenFit, AWindowAsHighAsTheScreenLeavesRoomForItsTitle) {
    EXPECT_EQ(fittedInto({0, 0, 1400, 900}, {0, 0, 1400, 900}, kFrame), QRect(4, 26, 1392, 870));
    EXPECT_EQ(fittedInto({0, 28, 1366, 740}, {0, 0, 1400, 900}, kFrame), QRect(4, 54, 1358, 710));
}

/// All windows of all places: the frame is in the room, and nothing that fits changes its size.
TEST(ScreenFit, TheFrameIsAlwaysInTheRoom) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> place(-1500, 1500), size(50, 2500);
    for (int i = 0; i < 5000; ++i) {
        const QRect room(place(random), place(random), 300 + size(random), 300 + size(random));
        const QRect window(place(random), place(random), size(random), size(random));
        const QRect fitted = fittedInto(room, window, kFrame);
        EXPECT_TRUE(room.contains(fitted.marginsAdded(kFrame)));
        const QSize most = room.marginsRemoved(kFrame).size();
        EXPECT_EQ(fitted.size(), window.size().boundedTo(most));
    }
}

}  // namespace
}  // namespace tactooth

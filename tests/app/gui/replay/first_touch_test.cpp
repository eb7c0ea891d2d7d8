// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/first_touch.h"

#include <gtest/gtest.h>

#include "app/gui/replay/ready_track.h"

namespace tactooth {
namespace {

using test::kTick;
using test::trackOf;

TEST(FirstTouch, IsThatOfTheFirstTickWithAContact) {
    for (const std::uint64_t touch : {1U, 2U, 999U, 1000U, 1001U, 2500U}) {
        FirstTouch first(trackOf(3000, 3, touch));
        EXPECT_TRUE(first.search());
        EXPECT_EQ(first.time(), kTick * static_cast<double>(touch)) << touch;
    }
}

TEST(FirstTouch, IsUnknownUntilTheTrackHasIt) {
    const auto track = trackOf(1000, 3);
    FirstTouch first(track);
    EXPECT_FALSE(first.search());
    EXPECT_FALSE(first.search());
    EXPECT_FALSE(first.time());
    track->append(TrackChunk(*trackOf(2000, 2, 1500)->chunkAt(1)));
    EXPECT_TRUE(first.search());
    EXPECT_EQ(first.time(), kTick * 1500);
}

TEST(FirstTouch, IsMissingInAFinishedTrackWithoutOne) {
    const auto track = trackOf(1500, 2);
    track->finish({}, {});
    FirstTouch first(track);
    EXPECT_TRUE(first.search());
    EXPECT_FALSE(first.time());
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_cursor.h"

#include <gtest/gtest.h>

#include "app/gui/replay/ready_track.h"
#include "app/gui/replay/replay_trace.h"

namespace tactooth {
namespace {

using test::trackOf;

TEST(ReplayCursor, PlaysAtItsSpeedAndPausesAtTheEnd) {
    const auto track = trackOf(4096, 4);
    track->finish({}, {});
    ReplayCursor cursor(track);
    EXPECT_TRUE(cursor.isPlaying());
    EXPECT_EQ(cursor.moment(), 0U);
    cursor.advance(0.5);
    EXPECT_EQ(cursor.time(), 0.5);
    EXPECT_EQ(cursor.moment(), 512U);
    cursor.setSpeed(4);
    cursor.advance(0.5);
    EXPECT_EQ(cursor.time(), 2.5);
    cursor.setSpeed(0.1);
    cursor.advance(1);
    EXPECT_NEAR(cursor.time(), 2.6, 1e-12);
    cursor.setPlaying(false);
    cursor.advance(1);
    EXPECT_NEAR(cursor.time(), 2.6, 1e-12);
    cursor.setSpeed(16);
    cursor.setPlaying(true);
    cursor.advance(1);
    EXPECT_EQ(cursor.time(), 4);
    EXPECT_EQ(cursor.moment(), 4096U);
    EXPECT_FALSE(cursor.isPlaying());
    cursor.setPlaying(true);  // from the start again
    EXPECT_EQ(cursor.time(), 0);
}

TEST(ReplayCursor, WaitsWhereTheTrackIsNotMadeYet) {
    const auto track = trackOf(1000, 10);
    ReplayCursor cursor(track);
    EXPECT_EQ(cursor.length(), 10);
    cursor.advance(5);
    EXPECT_TRUE(cursor.isPlaying());
    EXPECT_EQ(cursor.moment(), 1000U);
    cursor.jumpTo(7);
    cursor.advance(1);
    EXPECT_EQ(cursor.time(), 7);
    EXPECT_EQ(cursor.moment(), 1000U);  // the last one that is there
    track->append(trackOf(1000, 1)->chunkAt(0) != nullptr ? TrackChunk(*trackOf(1000, 1)->chunkAt(0)) : TrackChunk());
    EXPECT_EQ(cursor.moment(), 2000U);
}

TEST(ReplayCursor, StepsTickByTick) {
    const auto track = trackOf(2048, 2);
    track->finish({}, {});
    ReplayCursor cursor(track);
    cursor.step(1);
    EXPECT_FALSE(cursor.isPlaying());
    EXPECT_EQ(cursor.moment(), 1U);
    cursor.step(1);
    EXPECT_EQ(cursor.moment(), 2U);
    cursor.step(-5);
    EXPECT_EQ(cursor.moment(), 0U);
    EXPECT_EQ(cursor.time(), 0);
    cursor.jumpTo(99);
    EXPECT_EQ(cursor.time(), 2);
    cursor.step(1);
    EXPECT_EQ(cursor.moment(), 2048U);
    cursor.step(-1);
    EXPECT_EQ(cursor.moment(), 2047U);
    for (int i = 0; i < 1500; ++i) cursor.step(-1);  // across chunks
    EXPECT_EQ(cursor.moment(), 547U);
}

TEST(ReplayCursor, JumpsFromMarkToMark) {
    const auto track = trackOf(4096, 4);
    track->finish({}, {});
    ReplayCursor cursor(track);
    cursor.setPlaying(false);
    const std::vector<double> marks = {0.5, 1, 1, 3};
    cursor.jumpToNext(marks);
    EXPECT_EQ(cursor.time(), 0.5);
    cursor.jumpToNext(marks);
    EXPECT_EQ(cursor.time(), 1);
    cursor.jumpToNext(marks);
    EXPECT_EQ(cursor.time(), 3);
    cursor.jumpToNext(marks);
    EXPECT_EQ(cursor.time(), 3);
    cursor.jumpToPrevious(marks);
    EXPECT_EQ(cursor.time(), 1);
    cursor.jumpToPrevious(marks);
    EXPECT_EQ(cursor.time(), 0.5);
    cursor.jumpToPrevious(marks);
    EXPECT_EQ(cursor.time(), 0.5);
    cursor.jumpTo(1);  // while it plays, the mark that has just passed is not meant
    cursor.setPlaying(true);
    cursor.advance(0.2);
    cursor.jumpToPrevious(marks);
    EXPECT_EQ(cursor.time(), 0.5);
}

TEST(ReplayCursor, LeadsTwoRecordingsThroughOneTime) {
    const auto track = trackOf(2048, 2), other = trackOf(4096, 4);
    track->finish({}, {});
    other->finish({}, {});
    ReplayCursor cursor(track);
    cursor.setPlaying(false);
    cursor.setOther(other, 0.5);
    EXPECT_EQ(cursor.length(), 4.5);
    cursor.jumpTo(0.25);
    EXPECT_EQ(cursor.moment(), 256U);
    EXPECT_EQ(cursor.otherMoment(), 0U);  // it has not begun
    cursor.jumpTo(1);
    EXPECT_EQ(cursor.moment(), 1024U);
    EXPECT_EQ(cursor.otherTime(), 0.5);
    EXPECT_EQ(cursor.otherMoment(), 512U);
    cursor.step(1);
    EXPECT_EQ(cursor.moment(), 1025U);
    EXPECT_EQ(cursor.otherMoment(), 513U);
    cursor.jumpTo(2);
    cursor.step(1);  // the first has ended
    EXPECT_EQ(cursor.moment(), 2048U);
    EXPECT_EQ(cursor.otherMoment(), 1537U);
    cursor.step(-1);
    EXPECT_EQ(cursor.otherMoment(), 1536U);
    cursor.step(-1);
    EXPECT_EQ(cursor.moment(), 2047U);
    cursor.jumpTo(99);
    EXPECT_EQ(cursor.otherMoment(), 4096U);
    cursor.step(1);
    EXPECT_EQ(cursor.time(), 4.5);
    cursor.setOther(other, -1);  // it begins before the first
    EXPECT_EQ(cursor.length(), 3);
    EXPECT_EQ(cursor.time(), 3);
    cursor.jumpTo(0);
    EXPECT_EQ(cursor.otherMoment(), 1024U);
    cursor.removeOther();
    EXPECT_EQ(cursor.length(), 2);
}

TEST(ReplayCursor, WaitsForTheSlowerOfTwoTracks) {
    const auto track = trackOf(2048, 2), other = trackOf(1000, 4);
    track->finish({}, {});
    ReplayCursor cursor(track);
    cursor.setOther(other, 0.5);
    EXPECT_EQ(cursor.ready(), 0.5 + 1000.0 / 1024);
    cursor.advance(9);
    EXPECT_EQ(cursor.time(), cursor.ready());
    EXPECT_TRUE(cursor.isPlaying());
    other->append(TrackChunk(*trackOf(1000, 1)->chunkAt(0)));
    other->finish({}, {});
    cursor.advance(9);
    EXPECT_FALSE(cursor.isPlaying());
    EXPECT_EQ(cursor.time(), cursor.length());
    cursor.setPlaying(true);  // from the start again
    EXPECT_EQ(cursor.time(), 0);
}

TEST(ReplayTrace, ShowsTheSecondsBeforeTheMoment) {
    const auto track = trackOf(20'480, 20);
    const TickTrace trace = traceBefore(*track, 15'360);  // 15 s
    ASSERT_FALSE(trace.points().empty());
    EXPECT_NEAR(trace.points().back().time, 15, 2 * TickTrace::kInterval);
    EXPECT_NEAR(trace.points().front().time, 5, 2 * TickTrace::kInterval);
    for (const TickTrace::Point& point : trace.points()) {
        EXPECT_NEAR(point.force, point.time, 0.002);
        EXPECT_NEAR(point.depth, point.time / 100, 1e-4);
    }
    EXPECT_TRUE(traceBefore(*track, 0).points().empty());
    EXPECT_LT(traceBefore(*track, 2048).points().front().time, 2 * TickTrace::kInterval);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/chunk_builder.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "bench_scene.h"
#include "session/track/track_tooth.h"
#include "support/servo_tick.h"

namespace tactooth {
namespace {

constexpr std::uint64_t kChunks = 2 * TrackChunk::kStride + 5;
constexpr std::uint64_t kTicks = kChunks * TrackChunk::kTicks;
constexpr double kDepth = 2;  // mm, at the end

/// A track of many chunks, of ticks that hold nothing: a bur works its way down to and fro in one place, cut by cut.
struct LongTrack {
    LongTrack() {
        const std::shared_ptr<CutModel> model = test::blockOnTheBench();
        model->noteTouched();
        track = std::make_shared<SessionTrack>(*model, static_cast<double>(kTicks) * test::kTick);
        hashes.push_back(model->hash());
        ChunkBuilder builder(*model);
        const Instrument bur = test::flatBur();
        std::mt19937 random(7);
        std::uniform_real_distribution<double> across(-0.4, 0.4), height(-0.1, 0.1);
        Pose from = test::at(0, 0, 0.3);
        for (std::uint64_t tick = 1; tick <= kTicks; ++tick) {
            if (builder.isFull()) track->append(builder.take());
            TrackTick empty;
            empty.time = static_cast<double>(tick) * test::kTick;
            builder.add(empty);
            if (tick % kTicksOfACut == 0) {
                const double depth = kDepth * static_cast<double>(tick) / static_cast<double>(kTicks);
                const Pose to = test::at(across(random), across(random), height(random) - depth);
                model->sweep(bur.cutting, from, to);
                model->refreshSurface();
                builder.addStep(*model, model->takeTouched());
                from = to;
            }
            if (tick % kTicksOfAHash == 0) hashes.push_back(model->hash());
        }
        track->append(builder.take());
        track->finish({}, {});
    }

    static constexpr std::uint64_t kTicksOfACut = 250;
    static constexpr std::uint64_t kTicksOfAHash = TrackChunk::kTicks / 2;

    std::shared_ptr<SessionTrack> track;
    std::vector<std::uint64_t> hashes;  // after each kTicksOfAHash ticks
};

TEST(ChunkBuilder, FarJumpsReachTheSameToothAsNearOnes) {
    const LongTrack made;
    TrackTooth tooth(made.track);
    std::mt19937 random(8);
    for (int jump = 0; jump < 100; ++jump) {
        const std::size_t i = random() % made.hashes.size();
        tooth.moveTo(i * LongTrack::kTicksOfAHash);
        ASSERT_EQ(tooth.model().hash(), made.hashes[i]) << "jump " << jump << " to " << i;
    }
}

TEST(ChunkBuilder, AStrideHasTheNetChangeOfItsChunks) {
    const LongTrack made;
    std::size_t strides = 0;
    std::size_t chunkBytes = 0;
    for (std::uint64_t i = 0; i < kChunks; ++i) {
        const auto chunk = made.track->chunkAt(i);
        chunkBytes += chunk->whole.rawSize;
        EXPECT_EQ(chunk->stride.rawSize > 0, (i + 1) % TrackChunk::kStride == 0) << "chunk " << i;
        if (chunk->stride.rawSize == 0) continue;
        EXPECT_LT(chunk->stride.rawSize, chunkBytes) << "words that change again and again count once";
        EXPECT_GE(chunk->bytes(), chunk->stride.bytes.size());
        chunkBytes = 0;
        ++strides;
    }
    EXPECT_EQ(strides, 2U);
}

}  // namespace
}  // namespace tactooth

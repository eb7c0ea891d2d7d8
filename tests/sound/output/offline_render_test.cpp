// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/offline_render.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

std::vector<float> channel(const StereoSamples& stereo, std::size_t which) {
    std::vector<float> one;
    for (std::size_t i = which; i < stereo.size(); i += 2) one.push_back(stereo[i]);
    return one;
}

std::vector<TimedSoundState> steady(const DrillSoundState& state, Vec3 source = SoundPlacement().source) {
    return {{0.0, state, {source, {}}}};
}

OfflineSettings headphonesIf(bool headphones) {
    OfflineSettings settings;
    settings.headphones = headphones;
    return settings;
}

TEST(OfflineRender, HasExactlyTheLengthAskedFor) {
    for (const double seconds : {0.001, 0.5, 1.2345}) {
        const auto sound = renderOffline(steady(spinning(100000.0)), seconds);
        ASSERT_TRUE(sound) << sound.error().message();
        EXPECT_EQ(sound->size(), 2 * static_cast<std::size_t>(std::llround(seconds * kSoundRate)));
    }
}

TEST(OfflineRender, ToneInTheSamplesFollowsTheTrack) {
    const std::vector<TimedSoundState> track{
        {0.0, spinning(0.0), {}}, {1.0, spinning(400000.0), {}}, {1.5, spinning(100000.0), {}}};
    const auto sound = renderOffline(track, 1.5);
    ASSERT_TRUE(sound) << sound.error().message();
    const auto left = channel(*sound, 0);
    for (double t = 0.1; t < 1.4; t += 0.05) {
        if (std::abs(t - 1.0) < 0.03) continue;
        const double expected = (t < 1.0 ? 400000.0 * t : 400000.0 - 600000.0 * (t - 1.0)) / 60.0;
        const auto middle = static_cast<std::size_t>(t * kSoundRate);
        const double hz =
            spectrumOf(std::span(left).subspan(middle - 512, 1024)).peakHz(0.9 * expected, 1.1 * expected);
        EXPECT_NEAR(hz, expected, 0.005 * expected) << "at " << t << " s";
    }
}

TEST(OfflineRender, StraightAheadIsEquallyLoudOnBothSides) {
    const auto sound = renderOffline(steady(cutting("enamel", 5.0)), 1.0);
    ASSERT_TRUE(sound) << sound.error().message();
    EXPECT_NEAR(rms(channel(*sound, 0)), rms(channel(*sound, 1)), 1e-4);
    EXPECT_GT(rms(*sound), 0.05);
}

TEST(OfflineRender, SourceOnOneSideIsLouderThere) {
    for (const bool headphones : {false, true}) {
        const OfflineSettings settings = headphonesIf(headphones);
        const auto left = renderOffline(steady(cutting("dentin", 5.0), {-200.0, 0.0, -200.0}), 1.0, settings);
        const auto right = renderOffline(steady(cutting("dentin", 5.0), {200.0, 0.0, -200.0}), 1.0, settings);
        ASSERT_TRUE(left && right);
        EXPECT_GT(rms(channel(*left, 0)), 1.5 * rms(channel(*left, 1))) << "headphones " << headphones;
        EXPECT_GT(rms(channel(*right, 1)), 1.5 * rms(channel(*right, 0))) << "headphones " << headphones;
    }
}

TEST(OfflineRender, ABurThatPassesFromLeftToRightMovesTheEnergyAlong) {
    for (const bool headphones : {false, true}) {
        auto track = steady(cutting("dentin", 5.0), {-300.0, 0.0, -100.0});
        track.push_back({4.0, track[0].state, {{300.0, 0.0, -100.0}, {}}});
        const auto sound = renderOffline(track, 4.0, headphonesIf(headphones));
        ASSERT_TRUE(sound) << sound.error().message();
        double last = -1.0;
        for (std::size_t part = 0; part < 8; ++part) {
            const auto piece = std::span(*sound).subspan(part * kSoundRate, kSoundRate);
            const StereoSamples both(piece.begin(), piece.end());
            const double rightOverLeft = rms(channel(both, 1)) / rms(channel(both, 0));
            EXPECT_GT(rightOverLeft, last) << "headphones " << headphones << ", part " << part;
            last = rightOverLeft;
        }
        EXPECT_GT(last, 1.5) << "headphones " << headphones;
    }
}

TEST(OfflineRender, SpraySuctionAndBurComeEachFromTheirOwnPlace) {
    DrillSoundState state;
    auto track = steady(state);
    track[0].placement.mouth = {-200.0, 0.0, -100.0};
    track[0].placement.suction = {200.0, 0.0, -100.0};
    track[0].state.water = 1.0;
    const auto spray = renderOffline(track, 1.0);
    track[0].state = {};
    track[0].state.suction = 1.0;
    const auto suction = renderOffline(track, 1.0);
    ASSERT_TRUE(spray && suction);
    EXPECT_GT(rms(channel(*spray, 0)), 1.5 * rms(channel(*spray, 1)));
    EXPECT_GT(rms(channel(*suction, 1)), 1.5 * rms(channel(*suction, 0)));
}

TEST(OfflineRender, ListenerThatTurnsHearsTheSourceMove) {
    auto track = steady(cutting("dentin", 5.0));
    track[0].placement.listenerInWorld.rotation = Eigen::AngleAxisd(-0.8, Vec3::UnitY());  // turned to the right
    const auto sound = renderOffline(track, 0.5);
    ASSERT_TRUE(sound) << sound.error().message();
    EXPECT_GT(rms(channel(*sound, 0)), 1.5 * rms(channel(*sound, 1)));
}

TEST(OfflineRender, DistanceDoesNotMatter) {
    const auto near = renderOffline(steady(spinning(200000.0), {0.0, 0.0, -30.0}), 0.5);
    const auto far = renderOffline(steady(spinning(200000.0), {0.0, 0.0, -900.0}), 0.5);
    ASSERT_TRUE(near && far);
    EXPECT_NEAR(rms(*near), rms(*far), 1e-4);
}

TEST(OfflineRender, LoadedSessionNeverClips) {
    DrillSoundState state = cutting("enamel", 30.0, 400000.0);
    for (const bool headphones : {false, true}) {
        const auto sound = renderOffline(steady(state, {-300.0, 0.0, 0.0}), 3.0, headphonesIf(headphones));
        ASSERT_TRUE(sound) << sound.error().message();
        EXPECT_LT(peak(*sound), 1.0f) << "headphones " << headphones;
    }
}

TEST(OfflineRender, RefusesWhatMakesNoSense) {
    const auto states = steady(spinning(1.0));
    EXPECT_FALSE(renderOffline({}, 1.0));
    EXPECT_FALSE(renderOffline(states, 0.0));
    EXPECT_FALSE(renderOffline(states, std::nan("")));
    EXPECT_FALSE(renderOffline(states, 1e9));
    const std::vector<TimedSoundState> backwards{{1.0, {}, {}}, {0.5, {}, {}}};
    const auto refused = renderOffline(backwards, 1.0);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message().find("number 2"), std::string::npos) << refused.error().message();
}

}  // namespace
}  // namespace tactooth

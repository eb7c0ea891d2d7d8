// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/environment_voices.h"

#include <gtest/gtest.h>

#include "sound/files/sound_format.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

// In runs as the soundscape makes them; `add` adds one run.
template <class Add>
std::vector<float> rendered(double seconds, Add add) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * kSoundRate) / kControlFrames * kControlFrames, 0.0f);
    for (std::size_t i = 0; i < samples.size(); i += kControlFrames) add(std::span(samples).subspan(i, kControlFrames));
    return samples;
}

std::vector<float> water(double flow, double volume = 1.0) {
    WaterVoice voice(3);
    return rendered(3.0, [&](std::span<float> run) { voice.addTo(run, flow, volume); });
}

std::vector<float> suction(double wet, double volume = 1.0) {
    SuctionVoice voice(3);
    return rendered(3.0, [&](std::span<float> run) { voice.addTo(run, 1.0, wet, volume); });
}

TEST(WaterVoice, HissesHighWithATrickleBelow) {
    const Spectrum spectrum = averageSpectrum(water(1.0), 4096);
    EXPECT_GT(spectrum.bandPower(2500.0, 10000.0), spectrum.bandPower(0.0, 2500.0));
    EXPECT_GT(spectrum.bandPower(800.0, 2000.0), 20.0 * spectrum.bandPower(100.0, 400.0));
}

TEST(WaterVoice, LevelFollowsTheFlowDownToSilence) {
    EXPECT_GT(rms(water(1.0)), 1.5 * rms(water(0.5)));
    EXPECT_EQ(peak(water(0.0)), 0.0f);
    EXPECT_EQ(peak(water(1.0, 0.0)), 0.0f);
}

TEST(SuctionVoice, RushesLowerThanTheSprayHisses) {
    EXPECT_LT(averageSpectrum(suction(0.0), 4096).centroidHz(), 0.6 * averageSpectrum(water(1.0), 4096).centroidHz());
}

TEST(SuctionVoice, SlurpsUnevenlyWhereThereIsWater) {
    const auto unevenness = [](const std::vector<float>& samples) {
        double low = 1.0, high = 0.0;
        for (std::size_t i = kSoundRate; i + 4800 <= samples.size(); i += 4800) {
            const double level = rms(std::span(samples).subspan(i, 4800));
            low = std::min(low, level);
            high = std::max(high, level);
        }
        return high / low;
    };
    EXPECT_GT(unevenness(suction(1.0)), 1.25 * unevenness(suction(0.0)));
}

TEST(SuctionVoice, StopsInDigitalSilence) {
    SuctionVoice voice(3);
    (void)rendered(0.5, [&](std::span<float> run) { voice.addTo(run, 1.0, 1.0, 1.0); });
    const auto after = rendered(2.0, [&](std::span<float> run) { voice.addTo(run, 0.0, 0.0, 1.0); });
    EXPECT_EQ(peak(std::span(after).last(kSoundRate)), 0.0f);
}

TEST(EnvironmentVoices, ComeAndGoWithoutAClick) {
    WaterVoice spray(5);
    SuctionVoice tube(6);
    int run = 0;
    const auto samples = rendered(4.0, [&](std::span<float> out) {
        const bool on = ++run / 400 % 2 == 0;
        spray.addTo(out, on ? 1.0 : 0.0, 1.0);
        tube.addTo(out, on ? 0.0 : 1.0, 1.0, 1.0);
    });
    std::vector<float> steady = water(1.0);
    const std::vector<float> other = suction(1.0);
    for (std::size_t i = 0; i < steady.size(); ++i) steady[i] += other[i];
    EXPECT_LT(largestJump(samples), 1.1f * largestJump(steady));
}

}  // namespace
}  // namespace tactooth

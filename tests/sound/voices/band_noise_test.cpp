// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/band_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

std::vector<float> noiseIn(double centreHz, double octaves) {
    BandNoise noise(5);
    noise.tune(centreHz, octaves, 1.0f);
    std::vector<float> samples(kSoundRate * 4);
    for (float& sample : samples) sample = noise.next();
    return samples;
}

TEST(BandNoise, LoudnessDoesNotDependOnTheBand) {
    for (const double centre : {300.0, 1000.0, 4000.0, 8000.0, 12000.0}) {
        for (const double octaves : {0.3, 0.75, 1.0, 2.0}) {
            if (centre * std::exp2(0.5 * octaves) > 15000.0) continue;  // half the rate cuts such a band off
            EXPECT_NEAR(rms(noiseIn(centre, octaves)), 1.0, 0.08) << centre << " Hz, " << octaves << " octaves";
        }
    }
}

TEST(BandNoise, HalfPowerPointsAreWhereTheWidthSays) {
    // Well below half the rate, where the compression of the bilinear transform does not matter.
    const Spectrum spectrum = averageSpectrum(noiseIn(1000.0, 1.0), 2048);
    const auto around = [&](double hz) { return spectrum.bandPower(hz - 47.0, hz + 47.0); };
    EXPECT_NEAR(decibel(around(1000.0 / std::sqrt(2.0)) / around(1000.0)), -3.0, 0.8);
    EXPECT_NEAR(decibel(around(1000.0 * std::sqrt(2.0)) / around(1000.0)), -3.0, 0.8);
    EXPECT_LT(decibel(around(8000.0) / around(1000.0)), -25.0);
}

TEST(BandNoise, CentreGlidesToItsNewPlace) {
    BandNoise noise(5);
    noise.tune(2000.0, 0.3, 1.0f);
    for (int run = 0; run < 2000; ++run) {
        noise.tune(8000.0, 0.3, smoothingCoefficient(0.01, kControlFrames));
        for (int i = 0; i < kControlFrames; ++i) (void)noise.next();
    }
    std::vector<float> samples(kSoundRate);
    for (float& sample : samples) sample = noise.next();
    EXPECT_NEAR(averageSpectrum(samples, 4096).centroidHz(), 8000.0, 250.0);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/drill_synthesiser.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kRev = 1.0 / 60.0;  // turns a second for each rev/min

// Frequency of the tone of the rotation around the time `at`, searched within +-8 % of `expected`.
double toneNear(const std::vector<float>& sound, double at, double expected, std::size_t window) {
    const auto middle = static_cast<std::size_t>(at * kSoundRate) + DrillSynthesiser::kDelay;
    const Spectrum spectrum = spectrumOf(std::span(sound).subspan(middle - window / 2, window));
    return spectrum.peakHz(expected * 0.92, expected * 1.08);
}

TEST(DrillSynthesiser, ToneIsTheRotationAtEverySpeed) {
    for (const double rpm : {10000.0, 25000.0, 100000.0, 200000.0, 333333.0, 400000.0}) {
        const double hz = spectrumOf(steadySound(spinning(rpm), 0.4)).peakHz(rpm * kRev * 0.9, rpm * kRev * 1.1);
        EXPECT_NEAR(hz, rpm * kRev, 0.002 * rpm * kRev) << rpm << " rev/min";
    }
}

TEST(DrillSynthesiser, ToneFollowsARampFromStandstillToFullSpeed) {
    DrillSynthesiser synthesiser;
    const auto speedAt = [](double t) { return std::min(400000.0, 200000.0 * t); };
    const auto sound = renderDrill(synthesiser, 2.2, [&](double t) { return spinning(speedAt(t)); });
    for (double t = 0.15; t < 2.1; t += 0.05) {
        const double expected = speedAt(t) * kRev;
        // A window is symmetric, so that a ramp's mean speed in it is the speed at its middle; not across the corner.
        if (std::abs(t - 2.0) < 0.03) continue;
        EXPECT_NEAR(toneNear(sound, t, expected, 2048), expected, 0.005 * expected) << "at " << t << " s";
    }
}

TEST(DrillSynthesiser, ToneFollowsALoadStepWhileCutting) {
    DrillSynthesiser synthesiser;
    const auto speedAt = [](double t) {
        return t < 0.5 ? 400000.0 : 260000.0 + 140000.0 * std::exp(-(t - 0.5) / 0.35);
    };
    const auto sound = renderDrill(synthesiser, 1.5, [&](double t) {
        DrillSoundState state = t < 0.5 ? spinning(speedAt(t)) : cutting("enamel", 6.0, speedAt(t));
        return state;
    });
    for (const double t : {0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4}) {
        const double expected = speedAt(t) * kRev;
        EXPECT_NEAR(toneNear(sound, t, expected, 2048), expected, 0.005 * expected) << "at " << t << " s";
    }
}

TEST(DrillSynthesiser, NoLineThatIsNotOneOfTheMotorsOwn) {
    // Without drive air, so that hiss covers nothing. Aliased overtones would be seen first.
    for (double rpm = 60000.0; rpm <= 500000.0; rpm += 31000.0) {
        DrillSoundState state = spinning(rpm, 0.0);
        state.load = 1.0;
        const double turn = rpm * kRev;
        Spectrum spectrum = averageSpectrum(steadySound(state, 1.5), 16384);
        const double tone = spectrum.peakPower(turn * 0.98, turn * 1.02);
        for (const double ratio : {1.0, 2.0, 3.0, 4.0, 8.0, 0.4}) {
            for (std::size_t i = 0; i < spectrum.power.size(); ++i) {
                const double off = std::abs(spectrum.hz(i) - ratio * turn);
                if (off < 0.02 * ratio * turn + 6.0 * spectrum.hzPerBin) spectrum.power[i] = 0.0;
            }
        }
        EXPECT_LT(decibel(spectrum.peakPower(0.0, 24000.0) / tone), -80.0) << rpm << " rev/min";
    }
}

TEST(DrillSynthesiser, NoFoldedLineWhileSweepingFromStandstillToTheTop) {
    // Every tone ends below 21 kHz: above it nothing may remain, at any time of the sweep.
    DrillSynthesiser synthesiser;
    const auto sound = renderDrill(synthesiser, 2.0, [](double t) { return spinning(250000.0 * t, 0.0); });
    for (std::size_t start = 4096; start + 4096 <= sound.size(); start += 4096) {
        const Spectrum piece = spectrumOf(std::span(sound).subspan(start, 4096));
        EXPECT_LT(decibel(piece.peakPower(21500.0, 24000.0) / piece.peakPower(100.0, 20000.0)), -75.0) << start;
    }
}

// Loudest frame of the ultrasonic rest, which only clicks (or aliased tones) reach.
double loudestClick(std::span<const float> sound) {
    constexpr std::size_t kFrame = 512;
    double top = 0.0;
    for (std::size_t start = 0; start + kFrame <= sound.size(); start += kFrame / 2) {
        top = std::max(top, spectrumOf(sound.subspan(start, kFrame)).bandPower(21800.0, 24000.0));
    }
    return top;
}

struct Change {
    const char* name;
    DrillSoundState before, after;
    SoundMixer mixerAfter;
};

std::vector<Change> suddenChanges() {
    const DrillSoundState fast = spinning(400000.0, 0.0);
    DrillSoundState electric = spinning(200000.0, 0.0), loaded = fast;
    electric.motor = MotorKind::Electric;
    loaded.load = 1.0;
    return {{"speed halves", fast, spinning(200000.0, 0.0), {}},
            {"sudden start", spinning(0.0, 0.0), fast, {}},
            {"sudden stop", fast, spinning(0.0, 0.0), {}},
            {"load", fast, loaded, {}},
            {"other handpiece", spinning(200000.0, 0.0), electric, {}},
            {"motor volume", fast, fast, {.motor = 0.0}},
            {"master volume", fast, fast, {.master = 0.1}},
            {"mute", fast, fast, {.muted = true}}};
}

TEST(DrillSynthesiser, NoSuddenChangeOfTheMotorClicks) {
    for (const Change& change : suddenChanges()) {
        DrillSynthesiser synthesiser;
        const auto before = renderDrill(synthesiser, 0.5, [&](double) { return change.before; });
        synthesiser.setMixer(change.mixerAfter);
        const auto after = renderDrill(synthesiser, 0.5, [&](double) { return change.after; });

        const float steady =
            std::max(largestJump(std::span(before).last(12000)), largestJump(std::span(after).last(12000)));
        EXPECT_LT(largestJump(after), 1.1f * steady) << change.name;
        EXPECT_LT(std::abs(after.front() - before.back()), 1.1f * steady) << change.name;
        EXPECT_LT(decibel(loudestClick(after)), -72.0) << change.name;
    }
}

TEST(DrillSynthesiser, NoSuddenChangeOfTheCutClicks) {
    // Noise jumps anyway: no jump at a change may exceed that of steady cutting in enamel, the brightest material.
    const float steady = largestJump(steadySound(cutting("enamel", 15.0), 4.0));
    const std::vector<DrillSoundState> states{cutting("enamel", 15.0), cutting("dentin", 15.0), cutting("caries", 1.0),
                                              spinning(300000.0),      cutting("caries", 15.0), cutting("enamel", 0.1),
                                              cutting("dentin", 15.0), spinning(0.0, 0.0)};
    DrillSynthesiser synthesiser;
    const auto sound = renderDrill(
        synthesiser, 4.0, [&](double t) { return states[static_cast<std::size_t>(t / 0.05) % states.size()]; });
    EXPECT_LT(largestJump(sound), 1.1f * steady);
}

TEST(DrillSynthesiser, FullLoadStaysBelowTheCeiling) {
    for (const char* material : {"enamel", "dentin", "caries", "amalgam"}) {
        DrillSynthesiser synthesiser;
        const auto sound = renderDrill(synthesiser, 3.0, [&](double t) {
            DrillSoundState state = cutting(material, 1000.0, 500000.0);
            state.load = 1.0;
            state.contactCount = static_cast<unsigned>(t * 50.0);
            state.contactSpeed = 1000.0;
            return state;
        });
        EXPECT_LE(peak(sound), PeakLimiter::kCeiling * 1.0001f) << material;
        EXPECT_GT(rms(sound), 0.15) << material;
    }
}

TEST(DrillSynthesiser, StandstillWithoutAirIsDigitalSilence) {
    DrillSynthesiser synthesiser;
    (void)renderDrill(synthesiser, 0.5, [](double) { return cutting("enamel", 10.0); });
    const auto sound = renderDrill(synthesiser, 1.0, [](double) { return DrillSoundState{}; });
    EXPECT_EQ(peak(std::span(sound).last(24000)), 0.0f);
}

TEST(DrillSynthesiser, MutedIsDigitalSilence) {
    DrillSynthesiser synthesiser;
    synthesiser.setMixer({.muted = true});
    EXPECT_EQ(peak(renderDrill(synthesiser, 0.5, [](double) { return cutting("enamel", 10.0); })), 0.0f);
}

TEST(DrillSynthesiser, StallLeavesTheAirAlone) {
    const Spectrum running = averageSpectrum(steadySound(spinning(300000.0), 1.0), 8192);
    const Spectrum stalled = averageSpectrum(steadySound(spinning(0.0), 1.0), 8192);
    EXPECT_LT(decibel(stalled.peakPower(4900.0, 5100.0) / running.peakPower(4900.0, 5100.0)), -25.0);
    EXPECT_GT(rms(steadySound(spinning(0.0), 0.5)), 0.005);
}

// Modulation of the loudness some tens of times a second, relative to its mean.
double chatterOf(double load) {
    DrillSoundState state = cutting("enamel", 6.0);
    state.load = load;
    const auto sound = steadySound(state, 4.0);
    constexpr std::size_t kPiece = 240;  // 5 ms
    std::vector<float> loudness;
    for (std::size_t i = 0; i + kPiece <= sound.size(); i += kPiece)
        loudness.push_back(static_cast<float>(rms(std::span(sound).subspan(i, kPiece))));
    double mean = 0.0;
    for (const float value : loudness) mean += static_cast<double>(value) / static_cast<double>(loudness.size());
    for (float& value : loudness) value -= static_cast<float>(mean);
    return std::sqrt(averageSpectrum(loudness, 256).bandPower(1.0 * 240, 8.0 * 240)) / mean;
}

TEST(DrillSynthesiser, ChattersNearTheStallAndNotBefore) {
    EXPECT_NEAR(chatterOf(0.4), chatterOf(0.0), 0.1 * chatterOf(0.0));
    EXPECT_GT(chatterOf(1.0), 1.5 * chatterOf(0.4));
}

TEST(DrillSynthesiser, ChatterDoesNotChangeTheLevel) {
    DrillSoundState calm = cutting("enamel", 6.0), strained = calm;
    calm.load = 0.5;
    strained.load = 1.0;
    EXPECT_NEAR(rms(steadySound(strained, 6.0)) / rms(steadySound(calm, 6.0)), 1.0, 0.05);
}

DrillSoundState cuttingWith(int blades, double rpm) {
    DrillSoundState state = cutting("dentin", 2.0, rpm);
    state.motor = MotorKind::LowSpeed;
    state.blades = blades;
    return state;
}

TEST(DrillSynthesiser, BladesThatPassSlowlyEnoughSing) {
    for (const double rpm : {5000.0, 10000.0, 40000.0}) {
        for (const int blades : {6, 8}) {
            const double passes = blades * rpm * kRev;
            const auto lineOf = [&](int its) {
                const Spectrum spectrum = averageSpectrum(steadySound(cuttingWith(its, rpm), 2.0), 16384);
                return spectrum.peakPower(passes * 0.995, passes * 1.005);
            };
            EXPECT_GT(decibel(lineOf(blades) / lineOf(0)), 6.0) << blades << " at " << rpm;
        }
    }
    EXPECT_EQ(steadySound(cuttingWith(6, 300000.0), 0.2), steadySound(cuttingWith(0, 300000.0), 0.2))
        << "beyond hearing";
}

TEST(DrillSynthesiser, BladesDoNotChangeTheLevel) {
    const double diamond = rms(steadySound(cuttingWith(0, 10000.0), 4.0));
    EXPECT_NEAR(rms(steadySound(cuttingWith(8, 10000.0), 4.0)), diamond, 0.05 * diamond);
}

TEST(DrillSynthesiser, AnotherBurComesWithoutAClick) {
    const float steady = std::max(largestJump(steadySound(cuttingWith(8, 10000.0), 4.0)),
                                  largestJump(steadySound(cuttingWith(0, 10000.0), 4.0)));
    DrillSynthesiser synthesiser;
    const auto sound = renderDrill(synthesiser, 4.0, [&](double t) {
        return cuttingWith(std::array{8, 0, 6, 30}[static_cast<std::size_t>(t / 0.05) % 4], 10000.0);
    });
    EXPECT_LT(largestJump(sound), 1.1f * steady);
}

TEST(DrillSynthesiser, LevelRisesWithRemovalPower) {
    for (const char* material : {"enamel", "dentin", "caries", "amalgam", "composite"}) {
        double last = rms(steadySound(spinning(300000.0), 3.0));
        for (const double watt : {0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 30.0}) {
            const double level = rms(steadySound(cutting(material, watt), 3.0));
            EXPECT_GT(level, 1.02 * last) << material << ", " << watt << " W";
            last = level;
        }
    }
}

TEST(DrillSynthesiser, MaterialsAreAQuarterApartInBrightness) {
    for (const double rpm : {30000.0, 200000.0, 300000.0, 400000.0}) {
        for (const double watt : {0.5, 1.0, 3.0, 10.0}) {
            const auto centroid = [&](const char* material) {
                return averageSpectrum(steadySound(cutting(material, watt, rpm), 2.0), 4096).centroidHz();
            };
            const double enamel = centroid("enamel"), dentin = centroid("dentin"), caries = centroid("caries");
            EXPECT_GT(enamel, 1.25 * dentin) << rpm << " rev/min, " << watt << " W";
            EXPECT_GT(dentin, 1.25 * caries) << rpm << " rev/min, " << watt << " W";
        }
    }
}

TEST(DrillSynthesiser, VolumesActOnTheirOwnPart) {
    const auto soundWith = [](const SoundMixer& mixer) {
        DrillSynthesiser synthesiser;
        synthesiser.setMixer(mixer);
        (void)renderDrill(synthesiser, 0.3, [](double) { return cutting("caries", 5.0); });
        return averageSpectrum(renderDrill(synthesiser, 1.0, [](double) { return cutting("caries", 5.0); }), 4096);
    };
    const auto tone = [](const Spectrum& s) { return s.peakPower(4950.0, 5050.0); };
    const auto cut = [](const Spectrum& s) { return s.bandPower(1000.0, 1800.0); };
    const Spectrum full = soundWith({});
    const Spectrum halfMotor = soundWith({.motor = 0.5}), halfCut = soundWith({.cutting = 0.5}),
                   half = soundWith({.master = 0.5});
    EXPECT_NEAR(decibel(tone(halfMotor) / tone(full)), -6.02, 0.3);
    EXPECT_NEAR(decibel(cut(halfMotor) / cut(full)), 0.0, 0.3);
    EXPECT_NEAR(decibel(tone(halfCut) / tone(full)), 0.0, 0.3);
    EXPECT_NEAR(decibel(cut(halfCut) / cut(full)), -6.02, 0.3);
    EXPECT_NEAR(decibel(tone(half) / tone(full)), -6.02, 0.05);
    EXPECT_NEAR(decibel(cut(half) / cut(full)), -6.02, 0.05);
}

TEST(DrillSynthesiser, SameSeedSameSamplesOtherSeedOthers) {
    const auto soundOf = [](std::uint64_t seed) {
        DrillSynthesiser synthesiser(seed);
        return renderDrill(synthesiser, 1.0, [](double t) { return cutting("dentin", 10.0 * t, 300000.0 * t); });
    };
    EXPECT_EQ(soundOf(7), soundOf(7));
    EXPECT_NE(soundOf(7), soundOf(8));
}

TEST(DrillSynthesiser, NonsenseInTheStateStaysFiniteAndBounded) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = std::numeric_limits<double>::infinity();
    DrillSynthesiser synthesiser;
    synthesiser.setMixer({nan, huge, 5.0, false});
    int block = 0;
    const auto sound = renderDrill(synthesiser, 2.0, [&](double) {
        const std::array<double, 5> values{nan, huge, -huge, -3.0, 1e300};
        const auto value = [&](int i) { return values[static_cast<std::size_t>(block + i) % values.size()]; };
        ++block;
        return DrillSoundState{MotorKind::AirTurbine,
                               value(0),
                               value(1),
                               value(2),
                               value(3),
                               value(4),
                               {value(1), value(2), value(3), value(4), value(0), value(1), value(2)},
                               static_cast<std::uint32_t>(block),
                               value(3),
                               static_cast<std::uint32_t>(block),
                               value(4)};
    });
    for (const float sample : sound) ASSERT_LE(std::abs(sample), PeakLimiter::kCeiling * 1.0001f);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the WAV files that the program writes, because they are the sound that a listener gets.
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cli/cli_test.h"
#include "sound/files/sound_format.h"
#include "sound/sound_files.h"
#include "sound/spectrum.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

struct Wav {
    SF_INFO info{};
    std::vector<float> left, right;
};

Wav readWav(const std::filesystem::path& path) {
    Wav wav;
    SNDFILE* file = sf_open(path.c_str(), SFM_READ, &wav.info);
    if (file == nullptr) return wav;
    std::vector<float> both(static_cast<std::size_t>(wav.info.frames * wav.info.channels));
    EXPECT_EQ(sf_readf_float(file, both.data(), wav.info.frames), wav.info.frames);
    sf_close(file);
    for (std::size_t i = 0; i + 1 < both.size(); i += 2) {
        wav.left.push_back(both[i]);
        wav.right.push_back(both[i + 1]);
    }
    return wav;
}

class SoundCommand : public ::testing::Test {
protected:
    std::string profile(const std::string& rows) {
        writeText(folder_ / "speed.csv", "t,speed_rpm,power,material\n" + rows);
        return folder_ / "speed.csv";
    }
    std::string out() { return folder_ / "out.wav"; }
    ProgramRun sound(const std::string& file, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{"sound", "--profile", file, "--out", out()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTactooth(arguments);
    }
    /// The left channel; both channels are equal.
    std::vector<float> heard(const std::string& rows) {
        const ProgramRun run = sound(profile(rows));
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return readWav(out()).left;
    }
    /// Cuts at a steady speed for 1.5 s, after half a second of settling.
    std::vector<float> steadyCut(const std::string& material, double watt, int rpm) {
        std::ostringstream rows;
        for (const int time : {0, 2}) rows << time << ',' << rpm << ',' << watt << ',' << material << '\n';
        std::vector<float> samples = heard(rows.str());
        samples.erase(samples.begin(), samples.begin() + kSoundRate / 2);
        return samples;
    }
    std::size_t filesLeft() {
        return static_cast<std::size_t>(
            std::distance(std::filesystem::directory_iterator(folder_.path()), std::filesystem::directory_iterator()));
    }
    void expectRefused(const ProgramRun& run, const std::string& sentence) {
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_THAT(run.err, HasSubstr(sentence));
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_FALSE(std::filesystem::exists(out()));
    }

    TemporaryFolder folder_;
};

double toneAt(const std::vector<float>& samples, double time, double expected) {
    const auto middle = static_cast<std::size_t>(time * kSoundRate);
    return spectrumOf(std::span(samples).subspan(middle - 1024, 2048)).peakHz(0.92 * expected, 1.08 * expected);
}

TEST_F(SoundCommand, WritesStereoOf48kHzAnd16BitsAsLongAsTheProfile) {
    const ProgramRun run = sound(profile("0,0,0,none\n0.75,100000,0,none\n"));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    const Wav wav = readWav(out());
    EXPECT_EQ(wav.info.samplerate, 48000);
    EXPECT_EQ(wav.info.channels, 2);
    EXPECT_EQ(wav.info.format, SF_FORMAT_WAV | SF_FORMAT_PCM_16);
    EXPECT_EQ(wav.info.frames, 36000);
    EXPECT_EQ(wav.left, wav.right);
}

TEST_F(SoundCommand, TheFundamentalFollowsARampAndALoadStepWithinHalfAPercent) {
    const auto samples =
        heard("0,0,0,none\n2,400000,0,none\n2.5,400000,0,none\n2.5,260000,8,enamel\n3.5,280000,8,enamel\n");
    for (double t = 0.15; t < 3.4; t += 0.05) {
        if (std::abs(t - 2.0) < 0.03 || std::abs(t - 2.5) < 0.03) continue;  // no single frequency at a corner
        const double rpm = t < 2.0 ? 200000.0 * t : t < 2.5 ? 400000.0 : 260000.0 + 20000.0 * (t - 2.5);
        EXPECT_NEAR(toneAt(samples, t, rpm / 60), rpm / 60, 0.005 * rpm / 60) << "at " << t << " s";
    }
}

TEST_F(SoundCommand, NoLineButTheDrivesOwnStandsAboveMinusSeventyDecibels) {
    for (const int rpm : {45000, 133000, 217000, 290000, 351000, 400000}) {
        const double turn = rpm / 60.0;
        const Spectrum spectrum = averageSpectrum(steadyCut("none", 0, rpm), 16384);
        for (std::size_t i = 20; i + 20 < spectrum.power.size(); ++i) {
            const double hz = spectrum.hz(i);
            const auto isNear = [&](double ratio) { return std::abs(hz - ratio * turn) < 0.02 * ratio * turn + 30; };
            if (isNear(1) || isNear(2) || isNear(3) || isNear(4) || isNear(8) || isNear(0.4)) continue;
            std::vector<double> around(spectrum.power.begin() + static_cast<std::ptrdiff_t>(i) - 20,
                                       spectrum.power.begin() + static_cast<std::ptrdiff_t>(i) + 21);
            std::nth_element(around.begin(), around.begin() + 20, around.end());
            const bool isLine = spectrum.power[i] > 10 * around[20];  // 10 dB above the hiss
            EXPECT_FALSE(isLine && decibel(spectrum.power[i]) > -70.0) << hz << " Hz at " << rpm << " rev/min";
        }
    }
}

TEST_F(SoundCommand, NoChangeClicks) {
    // Only a click has power in the last two kilohertz below half the sample rate.
    const auto samples = heard(
        "0,300000,0,none\n0.5,300000,0,none\n0.5,300000,3,dentin\n1,300000,3,dentin\n1,250000,9,caries\n"
        "1.5,250000,9,caries\n1.5,400000,0,none\n2,400000,0,none\n2,0,0,none\n2.5,0,0,none\n");
    for (std::size_t start = 0; start + 512 <= samples.size(); start += 256) {
        const double rest = spectrumOf(std::span(samples).subspan(start, 512)).bandPower(22000.0, 24000.0);
        EXPECT_LT(decibel(rest), -65.0) << static_cast<double>(start) / kSoundRate << " s";
    }
}

TEST_F(SoundCommand, FullLoadDoesNotClip) {
    for (const char* material : {"enamel", "dentin", "caries", "amalgam"}) {
        EXPECT_LT(peak(steadyCut(material, 60, 400000)), 0.95f) << material;
    }
}

TEST_F(SoundCommand, AStandingBurIsSilent) {
    const auto samples = heard("0,400000,5,enamel\n0.5,400000,5,enamel\n1,0,0,none\n2,0,0,none\n");
    EXPECT_EQ(peak(std::span(samples).last(24000)), 0.0f);
}

TEST_F(SoundCommand, TheLevelRisesWithTheRemovalPower) {
    for (const char* material : {"enamel", "dentin", "caries"}) {
        double last = 0;
        for (const double watt : {0.0, 0.3, 1.0, 3.0, 8.0, 20.0}) {
            const double level = rms(steadyCut(material, watt, 300000));
            EXPECT_GT(level, 1.02 * last) << material << ", " << watt << " W";
            last = level;
        }
    }
}

TEST_F(SoundCommand, EnamelIsBrighterThanDentinAndDentinThanCaries) {
    for (const int rpm : {200000, 320000}) {
        const auto centroid = [&](const char* material) {
            return averageSpectrum(steadyCut(material, 3, rpm), 4096).centroidHz();
        };
        EXPECT_GT(centroid("enamel"), 1.25 * centroid("dentin")) << rpm;
        EXPECT_GT(centroid("dentin"), 1.25 * centroid("caries")) << rpm;
    }
}

TEST_F(SoundCommand, AStillBurKnocksWhereItLands) {
    const auto samples = heard("0,0,0,none\n0.5,0,0,none\n0.5,0,0,enamel\n1,0,0,enamel\n");
    EXPECT_EQ(peak(std::span(samples).first(23760)), 0.0f);
    EXPECT_GT(peak(std::span(samples).subspan(23760, 2400)), 0.03f);
}

TEST_F(SoundCommand, EveryDriveSoundsDifferent) {
    const std::string rows = "0,25000,0,none\n1,25000,0,none\n";
    std::vector<std::vector<float>> sounds;
    for (const char* drive : {"turbine", "electric", "low-speed"}) {
        EXPECT_EQ(sound(profile(rows), {"--drive", drive}).exitCode, 0);
        sounds.push_back(readWav(out()).left);
    }
    EXPECT_NE(sounds[0], sounds[1]);
    EXPECT_NE(sounds[1], sounds[2]);
}

TEST_F(SoundCommand, SprayFollowsTheDriveAndSuctionRunsAllTheTime) {
    const std::string rows = profile("0,0,0,none\n1,0,0,none\n1,300000,0,none\n2,300000,0,none\n");
    const auto levels = [&](const std::vector<std::string>& flags) {
        EXPECT_EQ(sound(rows, flags).exitCode, 0);
        const Wav wav = readWav(out());
        return std::pair(rms(std::span(wav.right).subspan(24000, 20000)), rms(std::span(wav.right).last(20000)));
    };
    const auto [still, turning] = levels({});
    const auto [stillWet, turningWet] = levels({"--water"});
    const auto [stillSucked, turningSucked] = levels({"--suction"});
    EXPECT_EQ(still, 0.0);
    EXPECT_EQ(stillWet, 0.0);
    EXPECT_GT(turningWet, turning);
    EXPECT_GT(stillSucked, 0.005);
    EXPECT_GT(turningSucked, turning);
}

TEST_F(SoundCommand, ARecordingOfTheDriveFollowsTheSpeed) {
    writeTone(folder_ / "mine.wav", 5000.0, 0.5);  // at the turbine's 400 000 rev/min
    const auto run = sound(profile("0,200000,0,none\n1,200000,0,none\n"), {"--sounds", folder_ / "mine.wav"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NEAR(toneAt(readWav(out()).left, 0.5, 2500.0), 2500.0, 12.0);
}

TEST_F(SoundCommand, RefusesARecordingThatIsNone) {
    writeText(folder_ / "mine.wav", "la la la");
    expectRefused(sound(profile("0,1,0,none\n1,1,0,none\n"), {"--sounds", folder_ / "mine.wav"}),
                  "mine.wav: this is neither WAV, FLAC nor Ogg");
    writeText(folder_ / "mine.toml", "[motor]\nfile = \"mine.wav\"\nspeed_rpm = 5000\n");
    expectRefused(sound(profile("0,1,0,none\n1,1,0,none\n"), {"--sounds", folder_ / "mine.toml"}),
                  "mine.toml, line 2: ");
}

TEST_F(SoundCommand, AMaterialOfOnesOwnIsHeardInItsOwnBand) {
    const std::string rows = profile("0,200000,5,gold\n2,200000,5,gold\n");
    expectRefused(sound(rows), "speed.csv, line 2: there is no material 'gold'; the materials are enamel, ");
    const auto centroid = [&](const std::string& hz) {
        writeText(folder_ / "mine.toml", "[gold]\nsound_centre = " + hz + "\n");
        const ProgramRun run = sound(rows, {"--materials", folder_ / "mine.toml"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        const Wav wav = readWav(out());
        return averageSpectrum(std::span(wav.left).last(kSoundRate), 4096).centroidHz();
    };
    EXPECT_GT(centroid("9000"), 1.25 * centroid("2000"));
}

TEST_F(SoundCommand, AMaterialOfOnesOwnHasItsOwnRecording) {
    const std::string materials = folder_ / "materials.toml", preset = folder_ / "school.toml";
    writeText(materials, "[gold]\n");
    writeTone(folder_ / "gold.wav", 3000.0, 0.5);
    writeText(preset, "[cutting.gold]\nfile = \"gold.wav\"\n");
    const auto toneIn = [&](const std::string& material) {
        const ProgramRun run = sound(profile("0,200000,5," + material + "\n2,200000,5," + material + "\n"),
                                     {"--sounds", preset, "--materials", materials});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        const Wav wav = readWav(out());
        return averageSpectrum(std::span(wav.left).last(kSoundRate), 8192).bandPower(2950.0, 3050.0);
    };
    EXPECT_GT(toneIn("gold"), 10 * toneIn("other"));
    std::filesystem::remove(out());
    expectRefused(sound(profile("0,1,0,none\n1,1,0,none\n"), {"--sounds", preset}),
                  "school.toml, line 1: there is no material 'gold'; the materials are enamel, ");
}

TEST_F(SoundCommand, AmalgamAndCompositeNeedNoFileOfMaterials) {
    const double idle = rms(steadyCut("none", 0, 300000));
    writeTone(folder_ / "cut.wav", 3000.0, 0.5);
    for (const std::string material : {"amalgam", "composite"}) {
        EXPECT_GT(rms(steadyCut(material, 5, 300000)), 1.2 * idle) << material;
        writeText(folder_ / "school.toml", "[cutting." + material + "]\nfile = \"cut.wav\"\n");
        const ProgramRun run = sound(profile("0,1,0,none\n1,1,0,none\n"), {"--sounds", folder_ / "school.toml"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
    }
}

TEST_F(SoundCommand, RefusesMaterialsThatAreNone) {
    const std::string rows = profile("0,1,0,none\n1,1,0,none\n");
    expectRefused(sound(rows, {"--materials", folder_ / "none.toml"}), "none.toml: there is no such file");
    writeText(folder_ / "mine.toml", "[gold]\nsound_centre = -5\n");
    expectRefused(sound(rows, {"--materials", folder_ / "mine.toml"}), "mine.toml, line 2: 'sound_centre' must be");
}

TEST_F(SoundCommand, DrawsTheSpectrum) {
    const std::string picture = folder_ / "out.png";
    EXPECT_EQ(sound(profile("0,0,0,none\n1,300000,0,none\n"), {"--spectrogram", picture}).exitCode, 0);
    EXPECT_EQ(readText(picture).substr(1, 3), "PNG");
}

TEST_F(SoundCommand, RefusesABadProfileWithFileAndLineAndLeavesNothing) {
    expectRefused(sound(profile("0,0,0,none\n1,fast,0,none\n")), "speed.csv, line 3: column 'speed_rpm'");
    expectRefused(sound(profile("0,0,0,none\n1,5,1,granite\n")), "speed.csv, line 3: there is no material 'granite'");
    expectRefused(sound(folder_ / "none.csv"), "none.csv: there is no such file");
    EXPECT_EQ(filesLeft(), 1U);
}

TEST_F(SoundCommand, APictureThatCannotBeWrittenLeavesNoSoundEither) {
    expectRefused(sound(profile("0,0,0,none\n1,5,0,none\n"), {"--spectrogram", folder_ / "no/where.png"}), "where.png");
    EXPECT_EQ(filesLeft(), 1U);
    EXPECT_EQ(runTactooth({"sound", "--out", out()}).exitCode, 2);
    EXPECT_EQ(sound(profile("0,0,0,none\n1,5,0,none\n"), {"--drive", "steam"}).exitCode, 2);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/wav_file.h"

#include <gtest/gtest.h>
#include <sndfile.h>

#include <array>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "support/test_data.h"

namespace tactooth {
namespace {

std::size_t filesIn(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(WavFile, ReadsBackAs48kHz16BitStereo) {
    const test::TemporaryFolder folder;
    std::vector<float> stereo;
    for (int i = 0; i < 1000; ++i) {
        stereo.push_back(std::sin(0.1f * static_cast<float>(i)));
        stereo.push_back(-0.001f * static_cast<float>(i));
    }
    ASSERT_TRUE(writeWav(folder / "a.wav", stereo));

    SF_INFO info{};
    SNDFILE* file = sf_open((folder / "a.wav").c_str(), SFM_READ, &info);
    ASSERT_NE(file, nullptr);
    EXPECT_EQ(info.samplerate, 48000);
    EXPECT_EQ(info.channels, 2);
    EXPECT_EQ(info.frames, 1000);
    EXPECT_EQ(info.format, SF_FORMAT_WAV | SF_FORMAT_PCM_16);
    std::vector<float> back(2000);
    EXPECT_EQ(sf_readf_float(file, back.data(), 1000), 1000);
    sf_close(file);
    for (std::size_t i = 0; i < back.size(); ++i) ASSERT_NEAR(back[i], stereo[i], 1.1f / 32767.0f);
}

TEST(WavFile, SamplesBeyondFullScaleAreHeldNotWrapped) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeWav(folder / "loud.wav", std::array{3.0f, -3.0f}));
    SF_INFO info{};
    SNDFILE* file = sf_open((folder / "loud.wav").c_str(), SFM_READ, &info);
    std::array<short, 2> back{};
    EXPECT_EQ(sf_readf_short(file, back.data(), 1), 1);
    sf_close(file);
    EXPECT_EQ(back[0], 32767);
    EXPECT_EQ(back[1], -32768);
}

/// The bytes that libsndfile writes of the same samples.
std::vector<char> bytesByLibsndfile(const std::filesystem::path& path, const std::vector<float>& stereo) {
    SF_INFO info{};
    info.samplerate = 48000;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
    sf_command(file, SFC_SET_CLIPPING, nullptr, SF_TRUE);
    sf_writef_float(file, stereo.data(), static_cast<sf_count_t>(stereo.size() / 2));
    sf_close(file);
    std::ifstream written(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(written), {}};
}

TEST(WavFile, HoldsTheBytesThatLibsndfileWritesWhateverThePieces) {
    const test::TemporaryFolder folder;
    std::mt19937 random(20261125);
    std::uniform_real_distribution<float> anywhere(-1.2f, 1.2f);
    for (const std::size_t frames : {1U, 7U, 120U, 4000U, 50'000U}) {
        std::vector<float> stereo(2 * frames);
        for (float& sample : stereo)
            sample = random() % 50 == 0 ? (random() % 2 == 0 ? 1.0f : -1.0f) : anywhere(random);
        auto file = WavWriter::create(folder / "a.wav", frames);
        ASSERT_TRUE(file) << file.error().message();
        for (std::size_t at = 0; at < stereo.size();) {
            const std::size_t count = std::min<std::size_t>(1 + random() % 5000, stereo.size() - at);
            file->write(std::span<const float>(stereo).subspan(at, count));
            at += count;
        }
        ASSERT_TRUE(file->commit());
        std::ifstream written(folder / "a.wav", std::ios::binary);
        EXPECT_EQ(std::vector<char>(std::istreambuf_iterator<char>(written), {}),
                  bytesByLibsndfile(folder / "b.wav", stereo))
            << frames;
    }
}

TEST(WavFile, MoreThanFourGigabytesAreRefusedBeforeAFileIsMade) {
    const test::TemporaryFolder folder;
    const auto file = WavWriter::create(folder / "a.wav", std::size_t{1} << 30);
    ASSERT_FALSE(file);
    EXPECT_NE(file.error().message().find("at most 4 GB"), std::string::npos);
    EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(WavFile, ReplacesAnOldFileAndLeavesNothingElse) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "a.wav") << "old";
    ASSERT_TRUE(writeWav(folder / "a.wav", std::vector<float>(200)));
    EXPECT_EQ(std::filesystem::file_size(folder / "a.wav"), 44u + 400u);
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WavFile, MissingFolderIsASentenceWithTheFilesName) {
    const test::TemporaryFolder folder;
    const auto written = writeWav(folder / "not/there.wav", std::vector<float>(2));
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message().find("not/there.wav"), std::string::npos) << written.error().message();
    EXPECT_EQ(filesIn(folder.path()), 0u);
}

TEST(WavFile, FolderInTheFilesPlaceIsASentenceAndLeavesNothing) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "taken.wav/inside");
    EXPECT_FALSE(writeWav(folder / "taken.wav", std::vector<float>(2)));
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/wav_file.h"

#include <gtest/gtest.h>
#include <sndfile.h>

#include <array>
#include <cmath>
#include <fstream>
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
    EXPECT_NE(written.error().message.find("not/there.wav"), std::string::npos) << written.error().message;
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

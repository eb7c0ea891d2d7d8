// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Whatever the bytes: a recording is refused with a sentence, or is a loop that plays finite samples.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sound/loop_player.h"
#include "sound/recording_file.h"
#include "sound_files.h"
#include "support/mutation.h"
#include "support/sanitizer.h"
#include "support/test_data.h"
#include "support/text_file.h"

// libsndfile 1.2 gives up on a damaged Ogg head without giving back what libvorbis took. Read by the leak sanitizer.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the sanitizer's name
extern "C" const char* __lsan_default_suppressions() { return "leak:vorbis_info_init\n"; }

namespace tactooth {
namespace {

std::vector<std::string> seeds() {
    const test::TemporaryFolder folder;
    std::vector<std::string> result;
    for (const test::SoundFileKind& kind : {test::SoundFileKind{SF_FORMAT_WAV | SF_FORMAT_PCM_16, 8000, 1},
                                            {SF_FORMAT_WAV | SF_FORMAT_FLOAT, 8000, 2},
                                            {SF_FORMAT_WAVEX | SF_FORMAT_PCM_24, 8000, 1},
                                            {SF_FORMAT_WAV | SF_FORMAT_IMA_ADPCM, 8000, 1},
                                            {SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 8000, 1},
                                            {SF_FORMAT_OGG | SF_FORMAT_VORBIS, 8000, 1}}) {
        test::writeTone(folder / "seed", 500, 0.1, kind);
        result.push_back(test::readText(folder / "seed"));
    }
    return result;
}

/// Whether the bytes were taken as a recording.
bool keepsThePromises(const std::string& bytes) {
    const auto recording = parseRecording(std::as_bytes(std::span(bytes)), "mine.wav");
    if (!recording) {
        const std::string& sentence = recording.error().message;
        EXPECT_TRUE(sentence.starts_with("mine.wav") && sentence.ends_with('.') && sentence.size() < 400) << sentence;
        EXPECT_EQ(sentence.find('\n'), sentence.npos) << sentence;
        return false;
    }
    LoopPlayer player;
    for (int i = 0; i < 2000; ++i) EXPECT_TRUE(std::isfinite(player.next(*recording, 0.01 * (i % 800))));
    return true;
}

TEST(RecordingMutation, EverySeedIsTaken) {
    for (const std::string& seed : seeds()) EXPECT_TRUE(keepsThePromises(seed));
}

TEST(RecordingMutation, ADamagedFileIsRefusedWithASentenceOrPlaysFiniteSamples) {
    const std::vector<std::string> good = seeds();
    std::mt19937 random(20261121);
    const int count = test::cases(20000, 1000);
    int accepted = 0;
    for (int round = 0; round < count; ++round) {
        std::string bytes = good[test::below(random, good.size())];
        for (std::size_t change = 1 + test::below(random, 3); change > 0; --change) test::damage(bytes, good, random);
        accepted += keepsThePromises(bytes) ? 1 : 0;
    }
    EXPECT_GT(accepted, count / 20);
    EXPECT_LT(accepted, count * 19 / 20);
}

}  // namespace
}  // namespace tactooth

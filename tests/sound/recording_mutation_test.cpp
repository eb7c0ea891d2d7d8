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

std::size_t below(std::mt19937& random, std::size_t limit) { return random() % std::max<std::size_t>(limit, 1); }

/// Changes bytes of the head more often than others, cuts, repeats or puts in what a hostile head would hold.
void mutate(std::string& bytes, std::mt19937& random) {
    const std::size_t at = below(random, random() % 2 == 0 ? std::min<std::size_t>(bytes.size(), 100) : bytes.size());
    switch (random() % 6) {
        case 0:
            bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
            break;
        case 2:
            bytes.erase(at, below(random, 60));
            break;
        case 3:
            bytes.insert(at, bytes.substr(at, below(random, 60)));
            break;
        case 4:
            bytes.resize(at + 1);
            break;
        default:
            bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at), 4, random() % 2 == 0 ? '\xff' : '\0');
    }
    if (bytes.empty()) bytes = "RIFF";
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
        std::string bytes = good[below(random, good.size())];
        for (std::size_t change = 1 + below(random, 3); change > 0; --change) mutate(bytes, random);
        accepted += keepsThePromises(bytes) ? 1 : 0;
    }
    EXPECT_GT(accepted, count / 20);
    EXPECT_LT(accepted, count * 19 / 20);
}

}  // namespace
}  // namespace tactooth

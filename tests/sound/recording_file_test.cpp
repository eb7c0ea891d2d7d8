// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "sound_files.h"
#include "spectrum.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
using ::testing::HasSubstr;

std::string refusal(const std::filesystem::path& path) {
    const auto recording = readRecording(path);
    return recording ? "accepted" : recording.error().message;
}

/// The same file, but with the bytes from `place` on replaced.
void patch(const std::filesystem::path& path, std::size_t place, std::string_view bytes) {
    std::string content = readText(path);
    content.replace(place, bytes.size(), bytes);
    writeText(path, content);
}

class RecordingFile : public ::testing::Test {
protected:
    std::filesystem::path file(const char* name) { return folder_ / name; }
    TemporaryFolder folder_;
};

TEST_F(RecordingFile, ReadsWavFlacAndOgg) {
    const std::array<std::pair<const char*, int>, 4> kinds{{{"a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16},
                                                            {"b.wav", SF_FORMAT_WAV | SF_FORMAT_FLOAT},
                                                            {"c.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_24},
                                                            {"d.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS}}};
    for (const auto& [name, format] : kinds) {
        writeTone(file(name), 1000.0, 0.5, {format, 44100, 2});
        const auto recording = readRecording(file(name));
        ASSERT_TRUE(recording) << recording.error().message;
        EXPECT_EQ(recording->rate(), 44100.0) << name;
        EXPECT_GT(recording->size(), 15000u) << name;
        EXPECT_LT(recording->size(), 22050u) << name;
    }
}

TEST_F(RecordingFile, RefusesAFileThatWasCutOff) {
    const std::array<std::pair<const char*, int>, 3> kinds{{{"a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16},
                                                            {"c.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_16},
                                                            {"d.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS}}};
    for (const auto& [name, format] : kinds) {
        writeTone(file(name), 1000.0, 2.0, {format, 48000, 1});
        const std::string whole = readText(file(name));
        for (const double share : {0.9, 0.5, 0.1, 0.001}) {
            writeText(file(name),
                      whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size())) + 1));
            EXPECT_THAT(refusal(file(name)), HasSubstr(name)) << share;
            EXPECT_NE(refusal(file(name)), "accepted") << name << ", " << share;
        }
    }
}

TEST_F(RecordingFile, RefusesARateOfZero) {
    writeTone(file("zero.wav"), 1000.0, 0.5);
    constexpr std::size_t kRateAt = 24;  // in the head of a WAV file
    patch(file("zero.wav"), kRateAt, std::string_view("\0\0\0\0", 4));
    EXPECT_THAT(refusal(file("zero.wav")), HasSubstr("zero.wav: "));
}

TEST_F(RecordingFile, RefusesAThousandChannels) {
    writeTone(file("many.wav"), 1000.0, 0.1, {SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 1000});
    EXPECT_EQ(refusal(file("many.wav")), file("many.wav").string() +
                                             ": the recording has 1000 channels, but 1 to 8 are expected; save it with "
                                             "one.");
}

TEST_F(RecordingFile, RefusesSamplesThatAreNoNumbers) {
    writeTone(file("nan.wav"), 1000.0, 0.5, {SF_FORMAT_WAV | SF_FORMAT_FLOAT, 48000, 1});
    patch(file("nan.wav"), readText(file("nan.wav")).size() - 4000, std::string_view("\0\0\xc0\x7f", 4));
    EXPECT_THAT(refusal(file("nan.wav")), HasSubstr("is not a finite number"));
}

TEST_F(RecordingFile, RefusesOtherKindsTextAndNothing) {
    writeTone(file("a.aiff"), 1000.0, 0.5, {SF_FORMAT_AIFF | SF_FORMAT_PCM_16, 48000, 1});
    EXPECT_THAT(refusal(file("a.aiff")), HasSubstr("neither WAV, FLAC nor Ogg"));
    writeText(file("text.wav"), "these are not samples, whatever the name says");
    EXPECT_THAT(refusal(file("text.wav")), HasSubstr("text.wav: this is neither WAV, FLAC nor Ogg"));
    writeText(file("empty.wav"), "");
    EXPECT_THAT(refusal(file("empty.wav")), HasSubstr("empty.wav"));
    EXPECT_THAT(refusal(file("none.wav")), HasSubstr("there is no such file"));
}

TEST_F(RecordingFile, RefusesAnHourBeforeItIsRead) {
    writeTone(file("long.wav"), 1000.0, 31.0, {SF_FORMAT_WAV | SF_FORMAT_PCM_16, 8000, 1});
    EXPECT_THAT(refusal(file("long.wav")), HasSubstr("a loop"));
}

}  // namespace
}  // namespace tactooth

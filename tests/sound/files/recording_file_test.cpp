// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/recording_file.h"

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
    return recording ? "accepted" : recording.error().message();
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
        ASSERT_TRUE(recording) << recording.error().message();
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

/// Four bytes, lowest first.
std::string number(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
    return bytes;
}

/// The lengths in a WAV file whose writer did not know its length.
struct Lengths {
    const char* writer;
    std::uint32_t file, samples;
};
constexpr std::size_t kFileLengthAt = 4, kDataAt = 36, kDataLengthAt = 40, kHead = 44;

class StreamedWav : public RecordingFile, public ::testing::WithParamInterface<Lengths> {};
INSTANTIATE_TEST_SUITE_P(
    Marks, StreamedWav,
    ::testing::Values(Lengths{"ones", 0xFFFFFFFF, 0xFFFFFFFF}, Lengths{"zeros", 0, 0},
                      Lengths{"sox", 0x7FFFF024, 0x7FFFF000}, Lengths{"most", 0x80000024, 0x80000000},
                      Lengths{"signed", 0x7FFFFFFF, 0x7FFFFFDB}, Lengths{"less the head", 0xFFFFFFFF, 0xFFFFFFFF - 36},
                      Lengths{"samples alone", 0xFFFFFFFF, 0}, Lengths{"file alone", 0, 0xFFFFFFFF}));

TEST_P(StreamedWav, IsReadToItsEnd) {
    for (const int format : {SF_FORMAT_PCM_16, SF_FORMAT_PCM_24, SF_FORMAT_FLOAT}) {
        writeTone(file("a.wav"), 1000.0, 0.5, {SF_FORMAT_WAV | format, 48000, 2});
        const std::size_t whole = readRecording(file("a.wav")).value().size();
        const std::string text = readText(file("a.wav"));
        const std::size_t data = text.find("data");
        patch(file("a.wav"), kFileLengthAt, number(GetParam().file));
        patch(file("a.wav"), data + 4, number(GetParam().samples));
        const auto recording = readRecording(file("a.wav"));
        ASSERT_TRUE(recording) << recording.error().message();
        EXPECT_NEAR(static_cast<double>(recording->size()), static_cast<double>(whole), 16) << GetParam().writer;
    }
}

TEST_P(StreamedWav, NeedNotEndWithASample) {
    writeTone(file("a.wav"), 1000.0, 0.5, {SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 2});
    patch(file("a.wav"), kFileLengthAt, number(GetParam().file));
    patch(file("a.wav"), kDataLengthAt, number(GetParam().samples));
    for (std::size_t less : {1u, 2u, 3u, 5u}) {
        const std::string text = readText(file("a.wav"));
        writeText(file("a.wav"), text.substr(0, text.size() - less));
        EXPECT_EQ(refusal(file("a.wav")), "accepted") << less;
    }
}

TEST_F(RecordingFile, ALengthThatSomebodyMeantIsBelieved) {
    writeTone(file("a.wav"), 1000.0, 0.5);
    const std::string whole = readText(file("a.wav"));
    ASSERT_EQ(whole.substr(kDataAt, 4), "data");
    const std::string half = whole.substr(0, whole.size() / 2);
    writeText(file("half.wav"), half);
    EXPECT_THAT(refusal(file("half.wav")), HasSubstr("it was cut off"));
    for (const std::uint32_t length : {0U, 0xFFFFFFFFU}) {  // of the file alone
        patch(file("half.wav"), kFileLengthAt, number(length));
        EXPECT_THAT(refusal(file("half.wav")), HasSubstr("it was cut off")) << length;
    }
    writeText(file("whole.wav"), whole);
    patch(file("whole.wav"), kFileLengthAt, number(0xFFFFFFFF));
    EXPECT_EQ(refusal(file("whole.wav")), "accepted");
}

TEST_F(RecordingFile, AWavWithoutSamplesStaysEmpty) {
    writeTone(file("a.wav"), 1000.0, 0.5);
    writeText(file("empty.wav"), readText(file("a.wav")).substr(0, kHead));
    patch(file("empty.wav"), kDataLengthAt, number(0));
    patch(file("empty.wav"), kFileLengthAt, number(kHead - 8));
    EXPECT_THAT(refusal(file("empty.wav")), HasSubstr("empty.wav: "));
    EXPECT_NE(refusal(file("empty.wav")), "accepted");
    const std::string list = "LIST" + number(26) + "INFOISFT" + number(14) + "some program \0" + std::string(1, '\0');
    writeText(file("listed.wav"), readText(file("empty.wav")) + list);
    EXPECT_NE(refusal(file("listed.wav")), "accepted");
}

TEST_F(RecordingFile, ReadsRf64) {
    writeTone(file("a.wav"), 1000.0, 0.5, {SF_FORMAT_RF64 | SF_FORMAT_PCM_16, 48000, 1});
    const std::string whole = readText(file("a.wav"));
    ASSERT_TRUE(whole.starts_with("RF64"));
    EXPECT_EQ(refusal(file("a.wav")), "accepted");
    const std::size_t lengths = whole.find("ds64") + 8;
    for (const std::uint32_t mark : {0U, 0xFFFFFFFFU}) {  // written through a pipe
        for (std::size_t at = lengths; at < lengths + 16; at += 4) patch(file("a.wav"), at, number(mark));
        EXPECT_EQ(refusal(file("a.wav")), "accepted") << mark;
    }
    writeText(file("a.wav"), whole.substr(0, whole.size() / 2));
    EXPECT_THAT(refusal(file("a.wav")), HasSubstr("it was cut off"));
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

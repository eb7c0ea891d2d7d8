// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/motion_files.h"
#include "journal/file/journal_reader.h"
#include "journal/file/journal_writer.h"
#include "support/test_data.h"
#include "support/text_file.h"
#include "view/render/image.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// Pictures and films of a recorded second. ffmpeg is a stand-in: a script that stores what it gets.
class Film : public test::MotionFiles {
protected:
    std::string recorded() {
        const ProgramRun run = runTactooth({"realtime", "--seconds", "1", "--record", file("s.ttsession")});
        EXPECT_LE(run.exitCode, 1) << run.err;  // 1: this machine was late now and then
        return file("s.ttsession");
    }
    /// `script`: of the stand-in; its last argument is the file to write.
    Environment withFfmpeg(const std::string& script) {
        fs::create_directories(file("bin"));
        std::ofstream(file("bin/ffmpeg")) << "#!/bin/sh\nfor last; do :; done\n" << script << "\n";
        fs::permissions(file("bin/ffmpeg"), fs::perms::owner_all);
        const char* const path = std::getenv("PATH");
        return {{"PATH", file("bin") + ":" + (path != nullptr ? path : "/usr/bin:/bin")}};
    }
    Environment withoutFfmpeg() {
        fs::create_directories(file("none"));
        return {{"PATH", file("none")}};
    }
    /// A copy of a recording that does not say how the mirror was held.
    static void withoutMirror(const fs::path& recording, const fs::path& copy) {
        const auto journal = JournalReader::open(recording);
        ASSERT_TRUE(journal) << journal.error().message();
        auto writer = JournalWriter::create(copy, journal->headerJson());
        ASSERT_TRUE(writer) << writer.error().message();
        for (const BlockPlace& block : journal->blocks()) {
            if (block.header.type == BlockType::Mirror || isOfContainer(block.header.type)) continue;
            auto payload = journal->payload(block);
            ASSERT_TRUE(payload) << payload.error().message();
            (*writer)->appendWhenRoom(
                {block.header.type, block.header.firstTick, block.header.ticks, std::move(*payload)});
        }
        ASSERT_TRUE((*writer)->close(journal->ticks()->end));
    }
    /// The share of the pixels that differ.
    static double differing(const Image& a, const Image& b) {
        EXPECT_EQ(a.pixels.size(), b.pixels.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
            count += a.pixels[i] != b.pixels[i];
        return static_cast<double>(count) / static_cast<double>(a.pixels.size());
    }
    std::vector<std::string> arguments(const std::string& film, std::vector<std::string> more = {}) {
        std::vector<std::string> all = {"replay", file("s.ttsession"), "--film", film, "--size", "64x48", "--fps", "5"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(Film, PicturesAreEvenlySpreadOverTheSession) {
    const ProgramRun run =
        runTactooth({"replay", recorded(), "--out", file("out"), "--pictures", "3", "--size", "80x60"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    for (int i = 1; i <= 3; ++i) {
        const auto image = readPng(file("out") + "/picture-00" + std::to_string(i) + ".png");
        ASSERT_TRUE(image) << image.error().message();
        EXPECT_EQ(image->size.width, 80);
        EXPECT_EQ(image->size.height, 60);
        const bool isEmpty = std::ranges::all_of(image->pixels, [&](const Rgba& p) { return p == image->pixels[0]; });
        EXPECT_FALSE(isEmpty);
    }
    EXPECT_FALSE(fs::exists(file("out") + "/picture-004.png"));
}

/// The recording shows it from half a second on, and not any more after a second and a half.
TEST_F(Film, PicturesShowTheMirrorWhereItWasHeld) {
    const std::string session = sourceFolder() / "tests/golden/data/ball-coarse.ttsession";
    withoutMirror(session, file("without.ttsession"));
    const auto pictures = [&](const std::string& recording, const std::vector<std::string>& more) {
        std::vector<std::string> command = {"replay", recording, "--out", file("out"), "--pictures", "5"};
        command.insert(command.end(), {"--size", "160x120"});
        command.insert(command.end(), more.begin(), more.end());
        const ProgramRun run = runTactooth(command);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        std::vector<Image> images;
        for (int i = 1; i <= 5; ++i) {
            auto image = readPng(file("out") + "/picture-00" + std::to_string(i) + ".png");
            EXPECT_TRUE(image) << image.error().message();
            images.push_back(image ? std::move(*image) : Image());
        }
        fs::remove_all(file("out"));
        return images;
    };
    const std::vector<std::string> dentist = {"--view", "dentist"};
    const auto with = pictures(session, dentist), without = pictures(file("without.ttsession"), dentist);
    const auto fromTheEye = pictures(session, {}), noEye = pictures(file("without.ttsession"), {});
    for (const std::size_t at : {0U, 1U, 2U, 3U, 4U}) {
        const bool isHeld = at == 1;  // 1 s; the others are at its bounds, or beyond them
        if (at != 0 && at != 2) {
            EXPECT_EQ(differing(with[at], without[at]) > 0.02, isHeld) << at;
        }
        EXPECT_EQ(differing(without[at], noEye[at]), 0) << "no recorded eye: that of a dentist";
        EXPECT_GT(differing(with[at], fromTheEye[at]), 0.02) << "the recorded eye";
    }
    EXPECT_EQ(differing(with[3], without[3]), 0);
}

TEST_F(Film, WithoutFfmpegIsAFolderOfPicturesAndTheSound) {
    (void)recorded();
    const ProgramRun run = runTactooth(arguments(file("work.mp4")), withoutFfmpeg());
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("ffmpeg is not installed"));
    EXPECT_FALSE(fs::exists(file("work.mp4")));
    int pictures = 0;
    for (const auto& entry : fs::directory_iterator(file("work.frames"))) {
        if (entry.path().extension() != ".png") continue;
        const auto image = readPng(entry.path());
        ASSERT_TRUE(image) << image.error().message();
        EXPECT_EQ(image->size.width, 64);
        ++pictures;
    }
    EXPECT_GE(pictures, 4);
    EXPECT_LE(pictures, 12);
    EXPECT_GT(fs::file_size(file("work.frames/sound.wav")), 48000 * 2 * 2 / 2);  // over half a second
}

/// 64 x 48 pixels of four bytes, five times a second; then picture and sound are joined.
TEST_F(Film, WithFfmpegIsOneFile) {
    (void)recorded();
    const std::string script =
        "echo \"$@\" >>'" + file("calls") +
        "'\ncase \"$*\" in *rawvideo*) wc -c <&0 >\"$last\";; *) echo joined >\"$last\"; wc -c </proc/self/fd/3 "
        ">>\"$last\"; wc -c </proc/self/fd/4 >>\"$last\";; esac";
    const ProgramRun run = runTactooth(arguments(file("work.mp4")), withFfmpeg(script));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    std::istringstream film(readText(file("work.mp4")));
    std::string word;
    std::size_t videoBytes = 0, soundBytes = 0;
    film >> word >> videoBytes >> soundBytes;
    EXPECT_EQ(word, "joined");
    EXPECT_GT(videoBytes, 0U);  // the number that the first call has written
    EXPECT_GT(soundBytes, 48000U * 2 * 4 / 2);
    const std::string calls = readText(file("calls"));
    EXPECT_THAT(calls, HasSubstr("-video_size 64x48 -framerate 5"));
    EXPECT_THAT(calls, HasSubstr("-f mp4"));
    EXPECT_FALSE(fs::exists(file("work.frames")));
}

TEST_F(Film, AtAnotherSpeedIsSilentAndHasAllItsPictures) {
    (void)recorded();
    const std::string script = "wc -c <&0 >\"$last\"";
    const ProgramRun run = runTactooth(arguments(file("work.mkv"), {"--speed", "0.5"}), withFfmpeg(script));
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const std::size_t bytes = std::stoul(readText(file("work.mkv")));
    EXPECT_EQ(bytes % (64 * 48 * 4), 0U);
    const std::size_t pictures = bytes / (64 * 48 * 4);
    EXPECT_GE(pictures, 8U);  // a second at half the speed and five pictures a second; the hand began a little later
    EXPECT_LE(pictures, 24U);
}

TEST_F(Film, AFailureOfFfmpegHasASentenceAndLeavesNoFile) {
    (void)recorded();
    const ProgramRun run = runTactooth(arguments(file("work.mp4")), withFfmpeg("echo 'no codec x264' >&2; exit 3"));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("no codec x264"));
    EXPECT_FALSE(fs::exists(file("work.mp4")));
    const ProgramRun empty = runTactooth(arguments(file("work.mp4")), withFfmpeg("cat >/dev/null"));
    EXPECT_EQ(empty.exitCode, 2);
    EXPECT_FALSE(fs::exists(file("work.mp4")));
}

TEST_F(Film, WhatCannotBeAFilmHasASentence) {
    (void)recorded();
    const std::vector<std::pair<std::vector<std::string>, std::string>> refused = {
        {{"--film", file("work.gif")}, ".mp4"},
        {{"--film", file("work.mp4"), "--size", "65x48"}, "even"},
        {{"--film", file("work.mp4"), "--size", "big"}, "size"},
        {{"--film", file("work.mp4"), "--view", "inside"}, "view"},
        {{"--film", file("work.mp4"), "--until", "0"}, "nothing to show"},
        {{"--film", file("missing/work.mp4")}, "missing"},
        {{"--film", file("s.ttsession")}, "s.ttsession"},
        {{"--pictures", "3"}, "--out"},
        {{"--film", file("work.mp4"), "--fps", "0"}, "--fps"},
    };
    for (const auto& [more, words] : refused) {
        std::vector<std::string> all = {"replay", file("s.ttsession")};
        all.insert(all.end(), more.begin(), more.end());
        const ProgramRun run = runTactooth(all, withFfmpeg("cat >/dev/null"));
        EXPECT_EQ(run.exitCode, 2) << more[1];
        EXPECT_THAT(run.err, HasSubstr(words));
    }
    EXPECT_TRUE(fs::exists(file("s.ttsession")));
}

}  // namespace
}  // namespace tactooth

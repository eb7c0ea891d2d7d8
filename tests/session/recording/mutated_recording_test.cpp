// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a recording is refused with a sentence, or all that it holds can be read, in bounded memory.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "../journal/journal_samples.h"
#include "../journal/resealed_journal.h"
#include "bench_scene.h"
#include "session/recording/session_recorder.h"
#include "session/recording/session_recording.h"
#include "support/sanitizer.h"
#include "support/test_data.h"
#include "track/stepped_session.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMutatedBytes = 1'000'000;  // in each of the two tests
constexpr unsigned kBytesOfAFile = 40;            // on average

/// Largest resident memory of this program so far, bytes.
std::size_t peakMemory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::vector<std::byte> bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

/// A second of cutting, with an undo and another bur.
void record(const fs::path& file) {
    const auto block = test::blockOnTheBench();
    auto recorder = SessionRecorder::create(file, *block, "block");
    ASSERT_TRUE(recorder) << recorder.error().message();
    (*recorder)->describe(workText({.title = "block", .exercise = "class-1", .events = {{}}}));
    for (const double sharpness : {1.0, 0.5}) {
        const Instrument bur = test::flatBur(sharpness);
        test::SteppedSession session(block, bur, {}, (*recorder)->begin({bur, HapticSettings{}}));
        for (int i = 0; i < 500; ++i) session.step({test::at(1e-3 * i, 0, 0.3 - 2e-3 * i), 1, true});
        session.edit(Edit::Undo);
        (*recorder)->end();
    }
    ASSERT_TRUE((*recorder)->close(block->hash()));
}

/// Reads all, but the tooth only if asked, as that takes as long as all else; gives how much of it could be read: 0 for
/// a file that is refused.
int readAll(const fs::path& file, bool withTooth) {
    const auto recording = SessionRecording::open(file);
    if (!recording) {
        EXPECT_FALSE(recording.error().message().empty());
        return 0;
    }
    int read = 1;
    std::uint64_t events = 0;
    read += recording->forEach([&](const SessionEvent&) { return ++events, true; }) ? 1 : 0;
    EXPECT_LE(events, recording->journal().bytes() * 64) << "a bit of a column is the least that an event takes";
    read += recording->hasChanges() ? 1 : 0;
    read += recording->work() ? 1 : 0;
    read += recording->end() ? 1 : 0;
    read += !withTooth || recording->makeModel() ? 1 : 0;
    return read;
}

class MutatedRecording : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_NO_FATAL_FAILURE(record(file_));
        whole_ = bytesOf(file_);
        ASSERT_EQ(readAll(file_, true), kAll);
        before_ = peakMemory();
    }
    void TearDown() override {
        RecordProperty("files", files_);
        RecordProperty("opened", opened_);
        RecordProperty("whole", wholeFiles_);
        const std::size_t grown = peakMemory() - before_;
        RecordProperty("grown_MiB", static_cast<int>(grown >> 20));
        EXPECT_GE(mutated_, test::cases(kMutatedBytes, kMutatedBytes / 50));
        EXPECT_GT(opened_, files_ / 10);
        EXPECT_LT(wholeFiles_, files_ * 9 / 10);
        if (!test::isSanitized()) {
            EXPECT_LT(grown, std::size_t{2} * kMaxRawBytes);
        }
    }
    [[nodiscard]] bool goesOn() const {
        return !HasFailure() && mutated_ < test::cases(kMutatedBytes, kMutatedBytes / 50);
    }
    /// Changes one byte or some more to others.
    void mutate(std::span<std::byte> bytes) {
        const std::size_t count = 1 + random_() % (2 * kBytesOfAFile - 1);
        for (std::size_t i = 0; i < count && !bytes.empty(); ++i, ++mutated_)
            bytes[random_() % bytes.size()] ^= static_cast<std::byte>(1 + random_() % 255);
    }
    void read(std::span<const std::byte> bytes, bool withTooth) {
        std::ofstream(file_, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        const int read = readAll(file_, withTooth);
        ++files_;
        opened_ += read > 0 ? 1 : 0;
        wholeFiles_ += read == kAll ? 1 : 0;
    }

    static constexpr int kAll = 6;
    test::TemporaryFolder folder_;
    fs::path file_ = folder_ / "s.ttsession";
    std::vector<std::byte> whole_;
    std::mt19937 random_{36};
    std::size_t before_ = 0, mutated_ = 0;
    int files_ = 0, opened_ = 0, wholeFiles_ = 0;
};

/// Half of the files have right checksums all the same, and most of them a whole header, without which nothing is read.
TEST_F(MutatedRecording, AMillionBytesOfItsFileAreReadOrRefused) {
    const auto journal = JournalReader::parse(whole_, "whole");
    ASSERT_TRUE(journal) << journal.error().message();
    const std::size_t header = journal->blocks().front().offset;
    while (goesOn()) {
        std::vector<std::byte> bytes = whole_;
        mutate(std::span(bytes).subspan(files_ % 5 == 0 ? 0 : header));
        if (files_ % 2 == 0) test::reseal(bytes);
        read(bytes, true);
    }
}

/// Behind compression and checksums: what each block says is damaged, and the file is made as a writer makes it.
TEST_F(MutatedRecording, AMillionBytesOfItsBlocksAreReadOrRefused) {
    const auto journal = JournalReader::parse(whole_, "whole");
    ASSERT_TRUE(journal) << journal.error().message();
    std::vector<JournalBlock> blocks;
    for (const BlockPlace& place : journal->blocks()) {
        if (isOfContainer(place.header.type)) continue;
        blocks.push_back({place.header.type, place.header.firstTick, place.header.ticks, *journal->payload(place)});
    }
    ASSERT_GT(blocks.size(), 5U);
    while (goesOn()) {
        std::vector<JournalBlock> damaged = blocks;
        const std::size_t hit = random_() % damaged.size();
        mutate(damaged[hit].payload);
        const bool isOfTooth = damaged[hit].type == BlockType::Attachment;
        read(test::journalBytes(damaged, true, journal->headerJson()), isOfTooth || files_ % 20 == 0);
    }
}

}  // namespace
}  // namespace tactooth

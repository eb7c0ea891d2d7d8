// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/recording_seal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench_scene.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "journal/file/journal_repair.h"
#include "journal/format/block_encoder.h"
#include "journal/format/file_header.h"
#include "session/recording/kept_recording.h"
#include "session/recording/session_recorder.h"
#include "session/scripts/cut_run.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using test::at;
using Verdict = SealReport::Verdict;
using Bytes = std::span<const std::byte>;

class RecordingSeal : public testing::Test {
protected:
    /// A cut of about two seconds; `seal` null: unsealed.
    void record(const std::string& name, const std::shared_ptr<const SigningKey>& seal) {
        const auto model = test::blockOnTheBench();
        auto recorder = SessionRecorder::create(folder_ / name, *model, "block", seal);
        ASSERT_TRUE(recorder) << recorder.error().message();
        std::vector<TimedPose> path;
        for (int i = 0; i < 2000; ++i) path.push_back({0.001 * i, at(0.5 * std::sin(0.01 * i), 0, 0.1 - 0.0002 * i)});
        HapticSettings settings;
        settings.spindle = constantSpeed(300'000);
        StepwiseSession session(model, cutSetup(test::flatBur(), settings),
                                [&](const SessionEvent& event) { (*recorder)->append(event); });
        ASSERT_TRUE(cutWithRemovalLaw(path, session, [](double, const Tick&, const ToothLoss&) {}));
        ASSERT_TRUE((*recorder)->close(model->hash()));
    }
    [[nodiscard]] SealReport report(const std::string& name, const std::optional<PublicKey>& wanted = {}) const {
        const auto recording = SessionRecording::open(folder_ / name);
        EXPECT_TRUE(recording) << recording.error().message();
        const auto found = checkRecordingSeal(*recording, wanted);
        EXPECT_TRUE(found) << found.error().message();
        return *found;
    }
    [[nodiscard]] std::vector<std::byte> bytesOfFile(const std::string& name) const {
        const auto bytes = readFile(folder_ / name);
        return {bytes->bytes().begin(), bytes->bytes().end()};
    }

    test::TemporaryFolder folder_;
    const std::shared_ptr<const SigningKey> key_ = SigningKey::make();
};

TEST_F(RecordingSeal, NamesItsKeyInTheHeaderAndIsIntact) {
    record("sealed", key_);
    const auto recording = SessionRecording::open(folder_ / "sealed");
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE(recording->facts().isSealed);
    EXPECT_EQ(recording->facts().sealKey, key_->publicKey());
    const SealReport found = report("sealed");
    EXPECT_EQ(found.verdict, Verdict::Intact);
    EXPECT_TRUE(found.isProof());
    EXPECT_NEAR(found.signedSeconds, 2, 0.1);
    EXPECT_EQ(report("sealed", key_->publicKey()).verdict, Verdict::Intact);
    EXPECT_EQ(report("sealed", SigningKey::make()->publicKey()).verdict, Verdict::OtherKey);
}

TEST_F(RecordingSeal, AnUnsealedRecordingProvesNothing) {
    record("plain", nullptr);
    EXPECT_EQ(report("plain").verdict, Verdict::NotSealed);
    EXPECT_FALSE(report("plain").isProof());
    const auto recording = SessionRecording::open(folder_ / "plain");
    EXPECT_FALSE(unsealedHeader(recording->journal().headerJson()));
}

TEST_F(RecordingSeal, ACutOffRecordingIsProvenUpToASecond) {
    record("sealed", key_);
    const auto whole = bytesOfFile("sealed");
    const auto journal = JournalReader::open(folder_ / "sealed");
    const auto last = std::ranges::find_if(journal->blocks(), [](const BlockPlace& place) {
        return place.header.type == BlockType::Events && place.header.firstTick >= 1000;
    });
    ASSERT_NE(last, journal->blocks().end());
    ASSERT_TRUE(writeFile(folder_ / "cut", Bytes(whole).first(last->end() - 3)));
    const SealReport found = report("cut");
    EXPECT_EQ(found.verdict, Verdict::CutOff);
    EXPECT_LE(found.signedSeconds, 1.6);
    EXPECT_LT(found.signedBytes, last->offset + 1);
}

TEST_F(RecordingSeal, AChangeIsFoundAndItsSecondNamed) {
    record("sealed", key_);
    auto bytes = bytesOfFile("sealed");
    const auto journal = JournalReader::open(folder_ / "sealed");
    const auto events = std::ranges::find_if(journal->blocks(), [](const BlockPlace& place) {
        return place.header.type == BlockType::Events && place.header.firstTick >= 1000;
    });
    bytes[events->offset + kBlockHeaderBytes + 5] ^= std::byte{8};
    ASSERT_TRUE(writeFile(folder_ / "changed", Bytes(bytes)));
    const SealReport found = report("changed");
    EXPECT_EQ(found.verdict, Verdict::Changed);
    EXPECT_EQ(found.changedFrom, events->offset);
    EXPECT_GT(found.changedFromSecond, 0.8);
    EXPECT_LT(found.changedFromSecond, 1.6);
}

/// Whoever takes the key out of the header cannot take the signatures out unnoticed.
TEST_F(RecordingSeal, SignaturesWithoutAKeyInTheHeaderAreAChange) {
    record("sealed", key_);
    const auto journal = JournalReader::open(folder_ / "sealed");
    std::string header = journal->headerJson();
    header.replace(header.find("\"sealed\""), 8, "\"seeled\"");
    auto forged = fileHeaderBytes(header);
    BlockEncoder encoder(fileHeaderCrc(forged));
    for (const BlockPlace& place : journal->blocks()) {
        const auto block = encoder.chain(place.header, *journal->storedPayload(place));
        forged.insert(forged.end(), block.begin(), block.end());
    }
    ASSERT_TRUE(writeFile(folder_ / "forged", Bytes(forged)));
    EXPECT_EQ(report("forged").verdict, Verdict::OtherKey);
    EXPECT_FALSE(report("forged").key);
}

TEST_F(RecordingSeal, ARepairedCopyIsNotSealedAndSaysWhoseItIs) {
    record("sealed", key_);
    const auto journal = JournalReader::open(folder_ / "sealed");
    const auto header = unsealedHeader(journal->headerJson());
    ASSERT_TRUE(header);
    ASSERT_TRUE(repairJournal(folder_ / "sealed", folder_ / "copy", *header));
    EXPECT_EQ(report("copy").verdict, Verdict::NotSealed);
    EXPECT_NE(header->find(keyText(key_->publicKey())), std::string::npos);
    const auto copy = SessionRecording::open(folder_ / "copy"), before = SessionRecording::open(folder_ / "sealed");
    ASSERT_TRUE(copy) << copy.error().message();
    EXPECT_TRUE(copy->journal().isComplete());
    EXPECT_EQ(copy->ticks(), before->ticks());
    EXPECT_EQ(copy->end().value().toothHash, before->end().value().toothHash);
}

TEST_F(RecordingSeal, AKeptRecordingIsSealedToo) {
    const auto tooth = test::blockOnTheBench();
    auto kept = KeptRecording::begin(RecordingFolder(folder_.path()), tooth, "Block", "{}", key_);
    ASSERT_TRUE(kept) << kept.error().message();
    EXPECT_TRUE((*kept)->isSealed());
    (*kept)->noteTouch();
    ASSERT_TRUE((*kept)->finish());
    const auto file = fs::directory_iterator(folder_.path())->path().filename().string();
    EXPECT_EQ(report(file, key_->publicKey()).verdict, Verdict::Intact);
}

}  // namespace
}  // namespace tactooth

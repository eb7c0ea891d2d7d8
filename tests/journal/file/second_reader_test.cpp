// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A reader in another language that knows nothing but docs/session-file.md reads what we write, byte for byte.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "geometry/files/atomic_file.h"
#include "geometry/util/byte_stream.h"
#include "journal/file/journal_reader.h"
#include "journal/file/journal_repair.h"
#include "journal/file/journal_trim.h"
#include "journal/file/seal_check.h"
#include "journal/format/attachment.h"
#include "journal/format/container_blocks.h"
#include "journal_samples.h"
#include "resealed_journal.h"
#include "sealed_samples.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using Bytes = std::span<const std::byte>;

constexpr int kSkipped = 77;

/// What the second reader prints; nothing if it cannot run here.
std::optional<std::string> secondReader(const std::string& arguments) {
    const std::string command = TACTOOTH_PYTHON " " TACTOOTH_SECOND_READER " " + arguments;
    FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    for (int sign = std::fgetc(pipe); sign != EOF; sign = std::fgetc(pipe)) text.push_back(static_cast<char>(sign));
    const int status = ::pclose(pipe);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kSkipped) return std::nullopt;
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << text;
    return text;
}

std::string hex(Bytes bytes) {
    std::ostringstream out;
    for (const std::byte byte : bytes) out << std::hex << std::setw(2) << std::setfill('0') << static_cast<int>(byte);
    return out.str();
}

std::string columnsText(Bytes payload) {
    ByteReader in(payload);
    std::string text;
    for (const IntegerColumn& column : getColumns(in)) {
        text += (text.empty() ? "[" : " [") + std::to_string(static_cast<int>(column.differences)) + ":";
        for (std::size_t i = 0; i < column.values.size(); ++i)
            text += (i == 0 ? "" : ",") + std::to_string(column.values[i]);
        text += "]";
    }
    return text;
}

std::string wordsText(Bytes payload) {
    ByteReader in(payload);
    std::string text;
    while (in.left() > 0) text += (text.empty() ? "" : " ") + std::to_string(in.get<std::uint64_t>());
    return text;
}

std::string describe(BlockType type, Bytes payload) {
    if (type == BlockType::Events || type == BlockType::Mirror) return columnsText(payload);
    if (type == BlockType::Attachment) {
        const AttachmentPiece piece = parseAttachment(payload).value();
        return piece.name + " " + std::to_string(piece.totalBytes) + " " + std::to_string(piece.offset) + " " +
               hex(piece.content);
    }
    const bool isWords = isOfContainer(type) && type != BlockType::Signature;
    return isWords ? wordsText(payload) : hex(payload);
}

std::string summary(const JournalReader& journal) {
    return std::to_string(journal.blocks().size()) + " blocks to byte " + std::to_string(journal.scan().end) + ", " +
           (journal.isComplete() ? "complete" : "not closed") + "\n";
}

std::string sealLine(const JournalReader& journal, const SigningKey& key) {
    if (journal.headerJson() != test::sealedHeader(key)) return "";
    const SealCheck check = checkSeal(journal, key.publicKey()).value();
    const std::array words = {"intact", "cut off", "changed"};
    return "seal " + std::string(words[static_cast<std::size_t>(check.state)]) + ", signed to byte " +
           std::to_string(check.signedBytes) + "\n";
}

/// What our own reader says of a file, as the second one prints it.
std::string ours(const std::filesystem::path& path) {
    const auto journal = JournalReader::open(path);
    if (!journal) return "refused: " + journal.error().message();
    std::string text = "header " + journal->headerJson() + "\n";
    for (const BlockPlace& place : journal->blocks()) {
        const BlockHeader& header = place.header;
        std::string line = "block " + std::to_string(place.offset) + " " +
                           std::to_string(static_cast<int>(header.type)) + " " + std::to_string(header.firstTick) +
                           " " + std::to_string(header.ticks) + " " + std::to_string(header.rawBytes) + " " +
                           describe(header.type, journal->payload(place).value());
        while (line.ends_with(' ')) line.pop_back();
        text += line + "\n";
    }
    return text + sealLine(*journal, *test::sampleKey(1)) + summary(*journal);
}

class SecondReader : public testing::Test {
protected:
    void expectSame(const std::string& name) {
        const auto theirs = secondReader((folder_ / name).string());
        if (!theirs) GTEST_SKIP() << "the second reader needs python3 and zstd";
        EXPECT_EQ(*theirs, ours(folder_ / name));
    }

    test::TemporaryFolder folder_;
    std::vector<std::byte> bytes_ = test::journalBytes(test::sampleBlocks(91, 3), true);
};

TEST_F(SecondReader, ReadsEachBlock) {
    ASSERT_TRUE(writeFile(folder_ / "a", Bytes(bytes_)));
    expectSame("a");
}

TEST_F(SecondReader, ReadsWhatWasRepairedAndTrimmed) {
    ASSERT_TRUE(writeFile(folder_ / "cut", Bytes(bytes_).first(bytes_.size() - 100)));
    ASSERT_TRUE(repairJournal(folder_ / "cut", folder_ / "repaired"));
    ASSERT_TRUE(trimJournal(folder_ / "repaired", folder_ / "trimmed", 250, 300));
    for (const char* name : {"cut", "repaired", "trimmed"}) expectSame(name);
}

TEST_F(SecondReader, ChecksSealsAsWeDo) {
    const std::vector<std::byte> sealed = test::sealedBytes(test::sampleBlocks(94, 1), true, test::sampleKey(1));
    ASSERT_TRUE(writeFile(folder_ / "sealed", Bytes(sealed)));
    ASSERT_TRUE(writeFile(folder_ / "cut", Bytes(sealed).first(sealed.size() - 70)));
    const auto journal = JournalReader::parse(sealed, "sealed");
    const auto hash =
        std::ranges::find(journal->blocks(), BlockType::Hash, [](const auto& b) { return b.header.type; });
    std::vector<std::byte> forged = sealed;
    forged[hash->offset + kBlockHeaderBytes] ^= std::byte{1};
    test::reseal(forged);
    ASSERT_TRUE(writeFile(folder_ / "forged", Bytes(forged)));
    for (const char* name : {"sealed", "cut", "forged"}) expectSame(name);
    EXPECT_TRUE(sealLine(*journal, *test::sampleKey(1)).starts_with("seal intact"));
}

TEST_F(SecondReader, ReadsNumbersOfAnySizeInColumns) {
    ByteWriter out;
    std::vector<std::int64_t> values(200);
    std::mt19937_64 random(92);
    for (std::int64_t& value : values) value = static_cast<std::int64_t>(random()) >> random() % 64;
    putColumns(out, std::vector<IntegerColumn>{
                        {Differences::None, values}, {Differences::First, values}, {Differences::Second, values}});
    const std::vector<std::byte> columns = out.take();
    const std::vector<JournalBlock> blocks{{BlockType::Events, 0, 200, columns}, {BlockType::Mirror, 0, 200, columns}};
    ASSERT_TRUE(writeFile(folder_ / "a", Bytes(test::journalBytes(blocks, true))));
    expectSame("a");
}

TEST_F(SecondReader, FindsTheSameEndOfDamagedFiles) {
    std::string names, wanted;
    std::mt19937 random(93);
    for (int i = 0; i < 60; ++i) {
        std::vector<std::byte> damaged = bytes_;
        if (i % 2 == 0) damaged.resize(random() % damaged.size());
        if (i % 2 == 1) damaged[random() % damaged.size()] ^= std::byte{1} << random() % 8;
        const std::string name = std::to_string(i);
        ASSERT_TRUE(writeFile(folder_ / name, Bytes(damaged)));
        names += " " + (folder_ / name).string();
        const auto journal = JournalReader::open(folder_ / name);
        wanted += journal ? summary(*journal) : "refused\n";
    }
    auto theirs = secondReader("--brief" + names);
    if (!theirs) GTEST_SKIP() << "the second reader needs python3 and zstd";
    std::istringstream lines(*theirs);
    std::string found;
    for (std::string line; std::getline(lines, line);) found += (line.starts_with("refused") ? "refused" : line) + "\n";
    EXPECT_EQ(found, wanted);
}

}  // namespace
}  // namespace tactooth

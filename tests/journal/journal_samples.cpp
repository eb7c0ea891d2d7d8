// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal_samples.h"

#include <gtest/gtest.h>

#include <memory>

#include "fake_journal_file.h"
#include "geometry/util/byte_text.h"
#include "journal/file/journal_appender.h"
#include "journal/format/attachment.h"

namespace tactooth::test {
namespace {

constexpr std::uint16_t kUnknownType = 4711;

std::vector<std::byte> tableOf(const std::vector<IntegerColumn>& columns) {
    ByteWriter out;
    putColumns(out, columns);
    return out.take();
}

std::vector<std::byte> noise(std::mt19937& random, std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    return bytes;
}

}  // namespace

std::vector<IntegerColumn> sampleColumns(std::mt19937& random, std::size_t rows) {
    std::vector<IntegerColumn> columns(3);
    columns[1].differences = Differences::First;
    columns[2].differences = Differences::None;
    std::int64_t place = static_cast<std::int32_t>(random()), speed = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        speed += static_cast<std::int64_t>(random() % 5) - 2;
        place += speed;
        columns[0].values.push_back(place);
        columns[1].values.push_back(row / 40);
        columns[2].values.push_back(random() % 50 == 0 ? -1 : 0);
    }
    return columns;
}

std::vector<JournalBlock> sampleBlocks(unsigned seed, int seconds) {
    std::mt19937 random(seed);
    std::vector<JournalBlock> blocks = attachmentBlocks("fnv1a:0123456789abcdef", asBytes("a case of no importance"));
    std::uint64_t tick = 0;
    for (int second = 0; second < seconds; ++second) {
        for (int half = 0; half < 2; ++half, tick += kSampleTicks)
            blocks.push_back({BlockType::Events, tick, kSampleTicks, tableOf(sampleColumns(random, kSampleTicks))});
        blocks.push_back({BlockType::Hash, tick, 0, noise(random, 8)});
        blocks.push_back({BlockType::Keyframe, tick, 0, noise(random, 40 + random() % 40)});
    }
    blocks.push_back({BlockType::Note, tick, 0, {}});
    blocks.push_back({static_cast<BlockType>(kUnknownType), tick, 0, std::vector<std::byte>(300, std::byte{'x'})});
    return blocks;
}

std::vector<std::byte> journalBytes(std::span<const JournalBlock> blocks, bool hasEnd, std::string_view header) {
    const auto disk = std::make_shared<FakeDisk>();
    Expected<JournalAppender> appender = JournalAppender::begin(fileOn(disk), "sample", header);
    EXPECT_TRUE(appender);
    for (const JournalBlock& block : blocks) EXPECT_TRUE(appender->append(block));
    const std::uint64_t end = blocks.empty() ? 0 : blocks.back().firstTick + blocks.back().ticks;
    if (hasEnd) {
        EXPECT_TRUE(appender->end(end));
    }
    return disk->bytes();
}

void expectBlocks(const JournalReader& journal, std::span<const JournalBlock> blocks) {
    ASSERT_GE(journal.blocks().size(), blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const BlockPlace& place = journal.blocks()[i];
        EXPECT_EQ(place.header.type, blocks[i].type);
        EXPECT_EQ(place.header.firstTick, blocks[i].firstTick);
        EXPECT_EQ(place.header.ticks, blocks[i].ticks);
        const auto payload = journal.payload(place);
        ASSERT_TRUE(payload) << payload.error().message();
        EXPECT_EQ(*payload, blocks[i].payload) << "block " << i;
    }
}

}  // namespace tactooth::test

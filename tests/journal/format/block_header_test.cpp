// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/block_header.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "geometry/util/byte_text.h"
#include "journal/codec/crc32c.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

using namespace std::string_view_literals;

constexpr BlockHeader kHeader{.type = BlockType::Keyframe,
                              .flags = kCompressedFlag,
                              .firstTick = 0x0807060504030201,
                              .ticks = 0x0D0C0B0A,
                              .storedBytes = 0x111213,
                              .rawBytes = 0x212223,
                              .previousCrc = 0x31323334,
                              .crc = 0x41424344};

bool isParsed(const BlockHeader& header) {
    // blockHeaderBytes takes valid headers only, so the bytes are changed behind it.
    BlockHeaderBytes bytes = blockHeaderBytes(kHeader);
    std::ranges::copy(std::as_bytes(std::span(&header.type, 1)), bytes.begin() + 4);
    std::ranges::copy(std::as_bytes(std::span(&header.flags, 1)), bytes.begin() + 6);
    std::ranges::copy(std::as_bytes(std::span(&header.firstTick, 1)), bytes.begin() + 8);
    std::ranges::copy(std::as_bytes(std::span(&header.ticks, 1)), bytes.begin() + 16);
    std::ranges::copy(std::as_bytes(std::span(&header.storedBytes, 1)), bytes.begin() + 20);
    std::ranges::copy(std::as_bytes(std::span(&header.rawBytes, 1)), bytes.begin() + 24);
    EXPECT_EQ(parseBlockHeader(bytes).has_value(), header.isValid());
    return header.isValid();
}

TEST(BlockHeader, HasTheDocumentedBytes) {
    const BlockHeaderBytes bytes = blockHeaderBytes(kHeader);
    EXPECT_EQ(
        asText(bytes),
        "TBLK\3\0\1\0\1\2\3\4\5\6\7\x8\xA\xB\xC\xD\x13\x12\x11\0\x23\x22\x21\0\x34\x33\x32\x31\x44\x43\x42\x41"sv);
    EXPECT_EQ(blockHeaderCrc(bytes), crc32c(std::span(bytes).first(32)));
}

TEST(BlockHeader, ComesBack) {
    const auto header = parseBlockHeader(blockHeaderBytes(kHeader));
    ASSERT_TRUE(header);
    EXPECT_EQ(blockHeaderBytes(*header), blockHeaderBytes(kHeader));
    EXPECT_EQ(header->endTick(), kHeader.firstTick + kHeader.ticks);
}

TEST(BlockHeader, IsRefusedWithoutItsMagic) {
    BlockHeaderBytes bytes = blockHeaderBytes(kHeader);
    bytes[3] = std::byte{'L'};
    EXPECT_FALSE(parseBlockHeader(bytes));
}

TEST(BlockHeader, KeepsTheLimits) {
    BlockHeader header = kHeader;
    header.storedBytes = kMaxStoredBytes, header.rawBytes = kMaxRawBytes;
    EXPECT_TRUE(isParsed(header));
    header.rawBytes = kMaxRawBytes + 1;
    EXPECT_FALSE(isParsed(header));
    header.storedBytes = kMaxStoredBytes + 1, header.rawBytes = kMaxRawBytes;
    EXPECT_FALSE(isParsed(header));
}

TEST(BlockHeader, AgreesWithItself) {
    BlockHeader header = kHeader;
    header.storedBytes = header.rawBytes = 8;
    EXPECT_FALSE(isParsed(header)) << "compressed, and not smaller";
    header.flags = 0;
    EXPECT_TRUE(isParsed(header));
    header.storedBytes = 7;
    EXPECT_FALSE(isParsed(header)) << "as it is, and smaller";
}

TEST(BlockHeader, EndsAtATickThatNumbersReach) {
    BlockHeader header = kHeader;
    header.ticks = std::numeric_limits<std::uint32_t>::max();
    header.firstTick = kMaxTick - header.ticks;
    EXPECT_TRUE(isParsed(header));
    EXPECT_EQ(header.endTick(), kMaxTick);
    ++header.firstTick;
    EXPECT_FALSE(isParsed(header));
    header.firstTick = std::numeric_limits<std::uint64_t>::max();
    EXPECT_FALSE(isParsed(header));
}

TEST(BlockHeader, KnowsOneFlagAndAnyType) {
    BlockHeader header = kHeader;
    header.type = static_cast<BlockType>(0xFFFF);
    EXPECT_TRUE(isParsed(header));
    header.flags |= 2;
    EXPECT_FALSE(isParsed(header));
    EXPECT_ASSERT((void)blockHeaderBytes(header));
}

}  // namespace
}  // namespace tactooth

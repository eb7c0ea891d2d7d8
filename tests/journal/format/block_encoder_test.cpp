// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/format/block_encoder.h"

#include <gtest/gtest.h>

#include <random>

#include "journal/codec/crc32c.h"

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;

BlockHeader headerOf(const std::optional<Bytes>& bytes) {
    EXPECT_TRUE(bytes && bytes->size() >= kBlockHeaderBytes);
    return parseBlockHeader(std::span(*bytes).first<kBlockHeaderBytes>()).value();
}

Bytes noise(std::size_t size) {
    std::mt19937_64 random(9);
    Bytes bytes(size);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    return bytes;
}

TEST(BlockEncoder, ChainsEachBlockToTheOneBefore) {
    BlockEncoder encoder(0xABCD);
    std::uint32_t before = 0xABCD;
    for (const std::size_t size : {0U, 3U, 70U, 5000U}) {
        const auto bytes = encoder.encode({BlockType::Note, 5, 0, Bytes(size)});
        const BlockHeader header = headerOf(bytes);
        EXPECT_EQ(header.previousCrc, before);
        // Everything but the last field of the header, in the order of the file.
        EXPECT_EQ(header.crc, crc32c(std::span(*bytes).subspan(36), crc32c(std::span(*bytes).first(32))));
        before = header.crc;
        EXPECT_EQ(encoder.crc(), before);
    }
}

TEST(BlockEncoder, CompressesWhereThatMakesABlockSmaller) {
    BlockEncoder encoder(0);
    const auto even = encoder.encode({BlockType::Events, 0, 500, Bytes(1000)});
    EXPECT_TRUE(headerOf(even).isCompressed());
    EXPECT_LT(even->size(), 100U);
    const auto random = encoder.encode({BlockType::Events, 0, 500, noise(1000)});
    EXPECT_FALSE(headerOf(random).isCompressed());
    EXPECT_EQ(random->size(), 1000 + kBlockHeaderBytes);
    EXPECT_FALSE(headerOf(encoder.encode({BlockType::Closed, 0, 0, Bytes(63)})).isCompressed());
}

TEST(BlockEncoder, RefusesWhatIsTooLargeAndGoesOn) {
    BlockEncoder encoder(1);
    EXPECT_FALSE(encoder.encode({BlockType::Keyframe, 0, 0, noise(kMaxStoredBytes + 1)}));
    EXPECT_FALSE(encoder.encode({BlockType::Keyframe, 0, 0, Bytes(kMaxRawBytes + 1)}));
    EXPECT_EQ(encoder.crc(), 1U);
    const BlockHeader whole = headerOf(encoder.encode({BlockType::Keyframe, 0, 0, Bytes(kMaxRawBytes)}));
    EXPECT_EQ(whole.rawBytes, kMaxRawBytes);
    EXPECT_EQ(whole.previousCrc, 1U);
    EXPECT_EQ(headerOf(encoder.encode({BlockType::Keyframe, 0, 0, noise(kMaxStoredBytes)})).storedBytes,
              kMaxStoredBytes);
}

TEST(BlockEncoder, ChainsAStoredBlockAnew) {
    BlockEncoder first(1), second(2);
    const auto bytes = first.encode({BlockType::Hash, 77, 0, noise(10)});
    const BlockHeader old = headerOf(bytes);
    const Bytes stored(bytes->begin() + kBlockHeaderBytes, bytes->end());
    const Bytes again = second.chain(old, stored);
    BlockEncoder third(2);
    EXPECT_EQ(again, third.encode({BlockType::Hash, 77, 0, noise(10)}));
}

}  // namespace
}  // namespace tactooth

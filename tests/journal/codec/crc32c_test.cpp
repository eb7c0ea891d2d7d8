// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/crc32c.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "geometry/util/byte_text.h"

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;
using Function = std::uint32_t (*)(std::span<const std::byte>, std::uint32_t);

std::vector<Function> waysToCompute() {
    std::vector<Function> ways{&crc32c, &crc32cByTables};
    if (hasCrc32cInstruction()) ways.push_back(&crc32cByInstruction);
    return ways;
}

Bytes counting(int first, int step) {
    Bytes bytes;
    for (int i = 0; i < 32; ++i) bytes.push_back(static_cast<std::byte>(first + i * step));
    return bytes;
}

/// One bit after the other, as the definition has it.
std::uint32_t bitByBit(std::span<const std::byte> bytes) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const std::byte byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82F63B78 : crc >> 1;
    }
    return ~crc;
}

TEST(Crc32c, GivesThePublishedValues) {
    for (const Function crc : waysToCompute()) {  // RFC 3720, B.4
        EXPECT_EQ(crc(Bytes(32, std::byte{0}), 0), 0x8A9136AAU);
        EXPECT_EQ(crc(Bytes(32, std::byte{0xFF}), 0), 0x62A8AB43U);
        EXPECT_EQ(crc(counting(0, 1), 0), 0x46DD794EU);
        EXPECT_EQ(crc(counting(31, -1), 0), 0x113FDB5CU);
        EXPECT_EQ(crc(asBytes("123456789"), 0), 0xE3069283U);
        EXPECT_EQ(crc({}, 0), 0U);
    }
}

TEST(Crc32c, AllWaysAgreeWithTheDefinitionAtEveryLengthAndPlace) {
    std::mt19937 random(1);
    Bytes bytes(300);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    for (std::size_t begin = 0; begin < 9; ++begin) {
        for (std::size_t size = 0; begin + size <= bytes.size(); ++size) {
            const auto part = std::span(bytes).subspan(begin, size);
            for (const Function crc : waysToCompute()) ASSERT_EQ(crc(part, 0), bitByBit(part)) << begin << " " << size;
        }
    }
}

TEST(Crc32c, ContinuesOverPieces) {
    std::mt19937 random(2);
    Bytes bytes(200);
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
        const std::span<const std::byte> whole(bytes);
        for (const Function crc : waysToCompute())
            ASSERT_EQ(crc(whole.subspan(cut), crc(whole.first(cut), 0)), crc(whole, 0)) << cut;
    }
}

TEST(Crc32c, SeesEveryFlippedBit) {
    Bytes bytes = counting(3, 7);
    const std::uint32_t before = crc32c(bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
        EXPECT_NE(crc32c(bytes), before) << bit;
        bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    }
}

}  // namespace
}  // namespace tactooth

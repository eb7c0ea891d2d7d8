// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/varint.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace tactooth {
namespace {

using Bytes = std::vector<unsigned char>;
constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
constexpr auto kMin = std::numeric_limits<std::int64_t>::min();

static_assert(zigzag(0) == 0 && zigzag(-1) == 1 && zigzag(1) == 2 && zigzag(-2) == 3 && zigzag(2) == 4);
static_assert(zigzag(kMax) == std::numeric_limits<std::uint64_t>::max() - 1);
static_assert(zigzag(kMin) == std::numeric_limits<std::uint64_t>::max());
static_assert(unzigzag(zigzag(kMin)) == kMin && unzigzag(zigzag(kMax)) == kMax && unzigzag(zigzag(-77)) == -77);

Bytes encoded(std::uint64_t value) {
    ByteWriter out;
    putVarint(out, value);
    Bytes bytes;
    for (const std::byte byte : out.bytes()) bytes.push_back(static_cast<unsigned char>(byte));
    return bytes;
}

bool isRead(const Bytes& bytes) {
    ByteReader in(std::as_bytes(std::span(bytes)));
    (void)getVarint(in);
    return in.ok() && in.left() == 0;
}

TEST(Varint, TakesSevenBitsAByteTheLowestFirst) {
    EXPECT_EQ(encoded(0), Bytes({0}));
    EXPECT_EQ(encoded(127), Bytes({127}));
    EXPECT_EQ(encoded(128), Bytes({0x80, 1}));
    EXPECT_EQ(encoded(300), Bytes({0xAC, 2}));
    EXPECT_EQ(encoded(std::numeric_limits<std::uint64_t>::max()),
              Bytes({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 1}));
}

TEST(Varint, EachNumberComesBack) {
    std::mt19937_64 random(3);
    ByteWriter out;
    std::vector<std::uint64_t> values(100000);
    for (std::uint64_t& value : values) value = random() >> random() % 64;
    for (const std::uint64_t value : values) putVarint(out, value);
    ByteReader in(out.bytes());
    for (const std::uint64_t value : values) ASSERT_EQ(getVarint(in), value);
    EXPECT_TRUE(in.ok());
    EXPECT_EQ(in.left(), 0U);
}

TEST(Varint, RefusesWhatIsCutOffOrLongerThanItHasToBe) {
    EXPECT_FALSE(isRead({}));
    EXPECT_FALSE(isRead({0x80}));
    EXPECT_FALSE(isRead({0x80, 0}));
    EXPECT_FALSE(isRead({0xFF, 0x80, 0}));
    EXPECT_FALSE(isRead({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 2}));
    EXPECT_FALSE(isRead({0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x81, 0}));
    EXPECT_TRUE(isRead({0x80, 1}));
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/integer_columns.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "journal/codec/varint.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

std::vector<std::byte> encoded(const std::vector<IntegerColumn>& columns) {
    ByteWriter out;
    putColumns(out, columns);
    return out.take();
}

std::vector<int> numbers(const std::vector<std::byte>& bytes) {
    std::vector<int> values;
    values.reserve(bytes.size());
    for (const std::byte byte : bytes) values.push_back(static_cast<int>(byte));
    return values;
}

void expectEqual(const std::vector<IntegerColumn>& read, const std::vector<IntegerColumn>& written) {
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].differences, written[i].differences);
        EXPECT_EQ(read[i].values, written[i].values);
    }
}

TEST(IntegerColumns, StoreTheDifferencesThatTheyName) {
    const std::vector<std::int64_t> values{10, 12, 14, 13};
    // Columns, rows, then for each column its differences and the errors of the prediction, zigzag.
    EXPECT_EQ(numbers(encoded({{Differences::None, values}})), std::vector<int>({1, 4, 0, 20, 24, 28, 26}));
    EXPECT_EQ(numbers(encoded({{Differences::First, values}})), std::vector<int>({1, 4, 1, 20, 4, 4, 1}));
    EXPECT_EQ(numbers(encoded({{Differences::Second, values}})), std::vector<int>({1, 4, 2, 20, 4, 0, 5}));
    EXPECT_EQ(numbers(encoded({})), std::vector<int>({0, 0}));
}

TEST(IntegerColumns, AnEvenMotionTakesAByteAValue) {
    IntegerColumn column;
    for (int i = 0; i < 1000; ++i) column.values.push_back(1'000'000'007LL * i);
    EXPECT_LT(encoded({column}).size(), 1000 + 16U);
}

TEST(IntegerColumns, AnyValuesComeBack) {
    std::mt19937_64 random(4);
    constexpr auto kMin = std::numeric_limits<std::int64_t>::min(), kMax = std::numeric_limits<std::int64_t>::max();
    for (int round = 0; round < 300; ++round) {
        std::vector<IntegerColumn> columns(random() % 5);
        const std::size_t rows = columns.empty() ? 0 : random() % 200;
        for (IntegerColumn& column : columns) {
            column.differences = static_cast<Differences>(random() % 3);
            const int shift = static_cast<int>(random() % 64);
            for (std::size_t row = 0; row < rows; ++row) {
                const bool isExtreme = random() % 20 == 0;
                const auto value = static_cast<std::int64_t>(random()) >> shift;
                column.values.push_back(isExtreme ? (value % 2 == 0 ? kMin : kMax) : value);
            }
        }
        const std::vector<std::byte> bytes = encoded(columns);
        ByteReader in(bytes);
        expectEqual(getColumns(in), columns);
        EXPECT_TRUE(in.ok());
        EXPECT_EQ(in.left(), 0U);
    }
}

TEST(IntegerColumns, RefuseEveryBeginning) {
    const std::vector<std::byte> bytes = encoded({{Differences::Second, {5, 900, -3}}, {Differences::None, {0, 1, 2}}});
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ByteReader in({bytes.data(), size});
        EXPECT_TRUE(getColumns(in).empty());
        EXPECT_FALSE(in.ok()) << size;
    }
}

TEST(IntegerColumns, RefuseCountsThatTheBytesCannotHold) {
    for (const auto& [columns, rows] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{
             {1, 1000}, {0, 7}, {kMaxColumns + 1, 0}, {2, kMaxColumnValues}, {~0ULL, ~0ULL}, {1, ~0ULL}, {256, 1}}) {
        ByteWriter out;
        putVarint(out, columns);
        putVarint(out, rows);
        for (int i = 0; i < 300; ++i) out.put(std::uint8_t{0});
        ByteReader in(out.bytes());
        EXPECT_TRUE(getColumns(in).empty());
        EXPECT_FALSE(in.ok()) << columns << " " << rows;
    }
}

TEST(IntegerColumns, RefuseDifferencesOfAnotherKind) {
    std::vector<std::byte> bytes = encoded({{Differences::Second, {1, 2}}});
    bytes[2] = std::byte{3};
    ByteReader in(bytes);
    EXPECT_TRUE(getColumns(in).empty());
    EXPECT_FALSE(in.ok());
}

TEST(IntegerColumns, HaveEqualLengths) {
    const std::vector<IntegerColumn> columns{{Differences::None, {1, 2}}, {Differences::None, {1}}};
    EXPECT_ASSERT((void)encoded(columns));
}

}  // namespace
}  // namespace tactooth

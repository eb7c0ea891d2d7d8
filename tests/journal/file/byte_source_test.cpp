// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/byte_source.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/files/atomic_file.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using Bytes = std::vector<std::byte>;

Bytes counted(std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 31 + i / 256);
    return bytes;
}

TEST(ByteSource, AFileAndMemoryGiveTheSame) {
    const test::TemporaryFolder folder;
    const Bytes bytes = counted(1000);
    ASSERT_TRUE(writeFile(folder / "a", std::span<const std::byte>(bytes)));
    const auto file = sourceOf(ReadableFile::open(folder / "a").value());
    const auto memory = sourceOf(std::span<const std::byte>(bytes));
    EXPECT_EQ(file->size(), 1000U);
    EXPECT_EQ(memory->size(), 1000U);
    for (const std::uint64_t offset : {0ULL, 1ULL, 990ULL, 999ULL, 1000ULL, 5000ULL}) {
        Bytes one(20), other(20);
        EXPECT_EQ(file->readAt(offset, one).value(), memory->readAt(offset, other).value()) << offset;
        EXPECT_EQ(one, other) << offset;
    }
}

TEST(ForwardReader, GivesEveryPiece) {
    const Bytes bytes = counted(3 * ForwardReader::kMost + 17);
    const auto source = sourceOf(std::span<const std::byte>(bytes));
    ForwardReader in(*source);
    std::mt19937 random(10);
    for (int round = 0; round < 2000; ++round) {
        const std::size_t offset = random() % (bytes.size() + 100), count = random() % ForwardReader::kMost;
        const auto view = in.view(offset, count);
        ASSERT_TRUE(view);
        const std::size_t begin = std::min(offset, bytes.size()), wanted = std::min(count, bytes.size() - begin);
        ASSERT_EQ(view->size(), wanted);
        EXPECT_TRUE(std::ranges::equal(*view, std::span(bytes).subspan(begin, wanted)));
    }
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/readable_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>

#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

std::string textAt(const ReadableFile& file, std::uint64_t offset) {
    std::array<std::byte, 4> bytes{};
    const Expected<std::size_t> count = file.readAt(offset, bytes);
    return count ? std::string(asText(std::span(bytes).first(*count))) : count.error().message();
}

TEST(ReadableFile, ReadsAtAnyPlaceUpToTheEnd) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a", "0123456789");
    const auto file = ReadableFile::open(folder / "a");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_EQ(file->size(), 10U);
    EXPECT_EQ(textAt(*file, 5), "5678");
    EXPECT_EQ(textAt(*file, 0), "0123");
    EXPECT_EQ(textAt(*file, 8), "89");
    EXPECT_EQ(textAt(*file, 10), "");
    EXPECT_EQ(textAt(*file, 1000), "");
}

TEST(ReadableFile, AnEmptyFileIsOneWithoutBytes) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a", "");
    const auto file = ReadableFile::open(folder / "a");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_EQ(file->size(), 0U);
}

TEST(ReadableFile, RefusesWhatIsNoRegularFile) {
    const test::TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_TRUE(ReadableFile::open(folder / "pipe").error().contains(msg::kFileNotRegular));
    EXPECT_TRUE(ReadableFile::open(folder.path()).error().contains(msg::kFileIsFolder));
    EXPECT_TRUE(ReadableFile::open(folder / "none").error().contains(msg::kFileMissing));
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

TEST(FileBytes, ReadsAFileOfJustTheMostBytes) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "a.txt", "12345");
    const auto read = readFile(folder / "a.txt", 5);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->text(), "12345");
}

TEST(FileBytes, RefusesALargerOneWithoutTakingItsMemory) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "huge.csv", "t,x\n");
    for (const std::uintmax_t size :
         std::array<std::uintmax_t, 5>{kMaxFileBytes + 1, std::uintmax_t{3} << 30, std::uintmax_t{10} << 30,
                                       std::uintmax_t{1} << 36, std::uintmax_t{1} << 40}) {
        std::error_code tooSmallADisk;
        std::filesystem::resize_file(folder / "huge.csv", size, tooSmallADisk);  // a sparse file, which uses no space
        if (tooSmallADisk) continue;
        const auto read = readFile(folder / "huge.csv");
        ASSERT_FALSE(read) << size;
        EXPECT_EQ(read.error().message(),
                  (folder / "huge.csv").string() + ": the file holds " + std::to_string(size) +
                      " bytes, and at most 2147483648 are read of such a file; choose another or "
                      "a smaller one.");
    }
}

TEST(FileBytes, NamesAreShownWithoutControlCharacters) {
    EXPECT_EQ(displayName("a\x1b[31m.stl"), "a?[31m.stl");
    EXPECT_EQ(displayName("z\xC3\xA4hne/36.stl"), "z\xC3\xA4hne/36.stl");
}

}  // namespace
}  // namespace tactooth

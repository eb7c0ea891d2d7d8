// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/render/image.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/test_data.h"

namespace tactooth {
namespace {

Image pattern() {
    Image image{{5, 3}, {}};
    for (int i = 0; i < 15; ++i) {
        const auto value = static_cast<std::uint8_t>(17 * i);
        image.pixels.push_back({value, static_cast<std::uint8_t>(255 - value), 3, static_cast<std::uint8_t>(100 + i)});
    }
    return image;
}

TEST(Image, PngKeepsEveryPixel) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writePng(pattern(), folder / "a.png"));
    const auto back = readPng(folder / "a.png");
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, pattern());
}

TEST(Image, MissingFolderIsASentenceAndLeavesNothing) {
    const test::TemporaryFolder folder;
    const auto result = writePng(pattern(), folder / "missing/a.png");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message().find("missing"), std::string::npos);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Image, DamagedPngIsASentence) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writePng(pattern(), folder / "a.png"));
    std::filesystem::resize_file(folder / "a.png", 60);
    EXPECT_FALSE(readPng(folder / "a.png"));
    std::ofstream(folder / "text.png") << "no picture";
    EXPECT_FALSE(readPng(folder / "text.png"));
    EXPECT_FALSE(readPng(folder / "absent.png"));
}

TEST(Image, CompareMeasuresMeanAndVisibleShare) {
    const Image a{{2, 1}, {{10, 10, 10, 255}, {0, 0, 0, 255}}};
    const Image b{{2, 1}, {{10, 13, 10, 255}, {0, 0, 30, 255}}};
    const ImageDifference difference = compare(a, b);
    EXPECT_DOUBLE_EQ(difference.mean, 33.0 / 6);
    EXPECT_DOUBLE_EQ(difference.worstShare, 0.5);
}

}  // namespace
}  // namespace tactooth

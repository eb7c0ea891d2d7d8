// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/edge_smoothing.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "view/render/image.h"

namespace tactooth {
namespace {

constexpr std::uint8_t kBright = 200;

/// A grey picture, rows from top to bottom. `isBright(x, y)`: the pixel is kBright and not black.
template <class IsBright>
Image pictureOf(ImageSize size, IsBright isBright) {
    Image image{size, {}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const std::uint8_t value = isBright(x, y) ? kBright : 0;
            image.pixels.push_back({value, value, value, 255});
        }
    }
    return image;
}

Image smoothed(Image image) {
    smoothEdges(image.pixels, image.size);
    return image;
}

/// The edge lies above row 3 in the left half and below it in the right half. It stands for a line that falls through
/// row 3 from the middle of the one half to the middle of the other, a tenth of a pixel in each column.
TEST(SmoothEdges, MixesEachPixelByItsAreaBeyondTheLine) {
    const Image image = smoothed(pictureOf({20, 7}, [](int x, int y) { return y < (x < 10 ? 3 : 4); }));
    const std::vector<int> row = {0, 0, 0, 0, 0, 10, 30, 50, 70, 90, 110, 130, 150, 170, 190, 200, 200, 200, 200, 200};
    for (int x = 0; x < 20; ++x) {
        for (int y = 0; y < 7; ++y) {
            const int expected = y == 3 ? row[static_cast<std::size_t>(x)] : y < 3 ? kBright : 0;
            EXPECT_EQ(image.at(x, y)[1], expected) << x << ' ' << y;
            EXPECT_EQ(image.at(x, y)[3], 255);
        }
    }
}

TEST(SmoothEdges, TreatsColumnsAsRowsAndDarkAsBright) {
    const auto below = [](int x, int y) { return 7 * y < 3 * x + 4; };
    const Image image = smoothed(pictureOf({40, 40}, below));
    const Image turned = smoothed(pictureOf({40, 40}, [&](int x, int y) { return below(y, x); }));
    const Image inverse = smoothed(pictureOf({40, 40}, [&](int x, int y) { return !below(x, y); }));
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            EXPECT_EQ(image.at(x, y), turned.at(y, x));
            EXPECT_NEAR(image.at(x, y)[0], kBright - inverse.at(x, y)[0], 1);
        }
    }
}

TEST(SmoothEdges, StraightEdgesAndTheOutermostPixelsStay) {
    const Image upright = pictureOf({50, 40}, [](int x, int) { return x < 23; });
    EXPECT_EQ(smoothed(upright), upright);
    const Image oblique = pictureOf({50, 40}, [](int x, int y) { return 5 * y < 2 * x; });
    const Image result = smoothed(oblique);
    EXPECT_NE(result, oblique);
    for (int x = 0; x < 50; ++x) {
        EXPECT_EQ(result.at(x, 0), oblique.at(x, 0));
        EXPECT_EQ(result.at(x, 39), oblique.at(x, 39));
    }
    for (int y = 0; y < 40; ++y) {
        EXPECT_EQ(result.at(0, y), oblique.at(0, y));
        EXPECT_EQ(result.at(49, y), oblique.at(49, y));
    }
}

TEST(SmoothEdges, PicturesOfAnySizeAreTaken) {
    for (const ImageSize size : {ImageSize{0, 0}, {1, 1}, {2, 9}, {9, 2}, {3, 3}, {3, 40}, {40, 3}, {17, 33}}) {
        const Image image = pictureOf(size, [](int x, int y) { return (x + 2 * y) % 5 < 2; });
        const Image result = smoothed(image);
        ASSERT_EQ(result.pixels.size(), image.pixels.size());
        for (const Rgba& pixel : result.pixels) EXPECT_LE(pixel[0], kBright);
    }
}

}  // namespace
}  // namespace tactooth

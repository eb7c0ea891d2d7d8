// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/icons/bur_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "instruments/bur_shape.h"

namespace tactooth {
namespace {

constexpr QSize kSize(120, 240);
constexpr double kScale = 240 / 9.75;  // pixels for each mm: the length that is shown, and a quarter of a millimetre

/// Width of what is drawn in a row, pixels.
int widthOf(const QImage& picture, int row) {
    int width = 0;
    for (int x = 0; x < picture.width(); ++x) width += qAlpha(picture.pixel(x, row)) > 127 ? 1 : 0;
    return width;
}

int widestOf(const QImage& picture, double fromMm, double toMm) {
    int widest = 0;
    for (double z = fromMm; z < toMm; z += 0.02) {
        const int row = static_cast<int>(240 - kScale * (z + 0.25));
        if (row >= 0 && row < picture.height()) widest = std::max(widest, widthOf(picture, row));
    }
    return widest;
}

TEST(BurPicture, ShowsTheHeadAsWideAsItIs) {
    for (const BurSpec& spec : burCatalogue()) {
        const QImage picture = drawBur(makeBur(spec, 4000), kSize);
        ASSERT_EQ(picture.size(), kSize);
        const int widest = widestOf(picture, 0, spec.headLength);
        EXPECT_LT(widest, kScale * spec.headDiameter + 2.5) << spec.name;
        // Six blades seen between two edges: cos(30 degrees) of the diameter.
        EXPECT_GT(widest, 0.86 * kScale * spec.headDiameter - 2.5) << spec.name;
    }
}

TEST(BurPicture, StandsOnItsTipWithTheShankAbove) {
    const BurSpec spec = *findBur("4");
    const QImage picture = drawBur(makeBur(spec, 4000), kSize);
    EXPECT_EQ(widthOf(picture, kSize.height() - 2), 0) << "below the tip";
    EXPECT_NEAR(widthOf(picture, 1), kScale * kShankDiameter, 2.5);
    EXPECT_LT(widestOf(picture, 1.6, 1.9), kScale * spec.headDiameter) << "the neck";
}

TEST(BurPicture, DiamondIsWarmerThanSteelAndItsShankIsSteel) {
    const auto warmth = [](const char* number, double fromMm, double toMm) {
        const BurSpec spec = *findBur(number);
        const QImage picture = drawBur(makeBur(spec, 4000), kSize);
        double sum = 0;
        for (int y = 0; y < picture.height(); ++y) {
            const double z = (kSize.height() - y) / kScale - 0.25;
            for (int x = 0; x < picture.width() && z > fromMm && z < toMm; ++x) {
                const QColor colour = picture.pixelColor(x, y);
                if (colour.alpha() == 255) sum += colour.redF() - colour.blueF();
            }
        }
        return sum;
    };
    EXPECT_GT(warmth("801-014", 0, 1), 0);
    EXPECT_LT(warmth("801-014", 3, 9), 0);
    EXPECT_LT(warmth("4", 0, 1), 0);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/view_marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "view/camera/orbit_camera.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{800, 500};

std::array<AxisLetter, kAxisLetters> lettersOf(StandardView view, double mesialX) {
    OrbitCamera eye;
    eye.fit(Box3(Vec3(-5, -5, -12), Vec3(5, 5, 8)), kSize.aspect());
    eye.setView(view, mesialX);
    return axisLetters(eye.camera(), kSize, mesialX, 20);
}

AxisLetter letter(const std::array<AxisLetter, kAxisLetters>& all, char which) {
    return *std::ranges::find(all, which, &AxisLetter::letter);
}

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
    for (double pixelsPerMm = 0.01; pixelsPerMm < 5000; pixelsPerMm *= 1.37) {
        const ScaleBar bar = scaleBar(pixelsPerMm, 160);
        EXPECT_LE(bar.pixels, 160 * (1 + 1e-9));
        EXPECT_GT(bar.pixels, 160 / 2.5 * (1 - 1e-9)) << "the next round length would fit";
        EXPECT_NEAR(bar.pixels, bar.millimetres * pixelsPerMm, 1e-9 * bar.pixels);
        const double first = bar.millimetres / std::pow(10, std::floor(std::log10(bar.millimetres) + 1e-9));
        EXPECT_TRUE(std::abs(first - 1) < 1e-6 || std::abs(first - 2) < 1e-6 || std::abs(first - 5) < 1e-6) << first;
    }
}

TEST(AxisLetters, OfAStandardViewAreAtTheMiddlesOfTheEdgesAndThoseAlongTheSightAreLeftOut) {
    for (const double mesialX : {1.0, -1.0}) {
        const auto buccal = lettersOf(StandardView::Buccal, mesialX);
        EXPECT_FALSE(letter(buccal, 'B').visible);
        EXPECT_FALSE(letter(buccal, 'L').visible);
        EXPECT_LT((letter(buccal, 'O').place - Vec2(400, 20)).norm(), 1e-6);
        EXPECT_LT((letter(buccal, 'A').place - Vec2(400, 480)).norm(), 1e-6);
        // From buccal, +x is on the left.
        EXPECT_LT((letter(buccal, 'M').place - Vec2(mesialX > 0 ? 20 : 780, 250)).norm(), 1e-6);
        EXPECT_LT((letter(buccal, 'D').place - Vec2(mesialX > 0 ? 780 : 20, 250)).norm(), 1e-6);
    }
}

TEST(AxisLetters, StayAtTheirSideBetweenBuccalAndOcclusal) {
    const auto occlusal = lettersOf(StandardView::Occlusal, 1), buccal = lettersOf(StandardView::Buccal, 1);
    EXPECT_FALSE(letter(occlusal, 'O').visible);
    EXPECT_LT((letter(occlusal, 'M').place - letter(buccal, 'M').place).norm(), 1e-6);
    EXPECT_GT(letter(occlusal, 'B').place.y(), 400) << "below: the eye has leaned over from buccal";
}

TEST(ViewMarks, AreDrawnIntoAPicture) {
    OrbitCamera eye;
    Image image{kSize, std::vector<Rgba>(static_cast<std::size_t>(kSize.width * kSize.height), Rgba{90, 90, 90, 255})};
    const Image before = image;
    drawViewMarks(image, eye.camera(), 1, 20);
    EXPECT_NE(image, before);
    const auto brightest = std::ranges::max(image.pixels, {}, [](const Rgba& pixel) { return pixel[0]; });
    EXPECT_GT(brightest[0], 220);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// What hides the line of sight turns to glass, in pictures and in id pictures.
#include <gtest/gtest.h>

#include "support/shapes.h"
#include "view/camera/magnifier.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::kTestSize;
using GlassTest = test::RendererTest;

constexpr std::size_t kBall = 0, kPlate = 1;
constexpr int kMiddleX = kTestSize.width / 2, kMiddleY = kTestSize.height / 2;

/// A red ball under a plate, seen from above. The top of the ball must stay in sight.
Scene ballUnderPlate() {
    Appearance red;
    red.colour = Vec3f(0.8F, 0.1F, 0.1F);
    Scene scene = test::sceneOf({test::objectOf(test::sphere(Vec3::Zero(), 3, 32, 32), red),
                                 test::objectOf(test::box(Vec3(-7, -7, 10), Vec3(7, 7, 11)), appearances::steel())},
                                {0, 1.5707963});
    scene.objects[kPlate].glassAbove = kAllGlass;
    scene.sight = SightLine{Vec3(0, 0, 3), Vec3(0, 0, 4), 1};
    scene.lighting = operatingLight(scene.camera);
    return scene;
}

double difference(const Rgba& a, const Rgba& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::abs(a[i] - b[i]);
    return sum;
}

TEST_F(GlassTest, ShowsWhatItWouldHide) {
    const Scene scene = ballUnderPlate();
    Scene solid = scene, ballAlone = scene;
    solid.sight.reset();
    ballAlone.objects.pop_back();
    RenderSettings settings = kQuick;
    settings.shadows = Shadows::None;  // glass throws the shadow of the body
    const Rgba wanted = draw(ballAlone, settings).at(kMiddleX, kMiddleY);
    const Rgba through = draw(scene, settings).at(kMiddleX, kMiddleY);
    const Rgba hidden = draw(solid, settings).at(kMiddleX, kMiddleY);
    EXPECT_GT(difference(hidden, wanted), 100);
    EXPECT_LT(difference(through, wanted), 0.25 * difference(hidden, wanted));
}

TEST_F(GlassTest, FarFromTheSightLineTheBodyIsSolidAsBefore) {
    const Scene scene = ballUnderPlate();
    Scene solid = scene;
    solid.sight.reset();
    const Image with = draw(scene), without = draw(solid);
    std::size_t same = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) same += with.pixels[i] == without.pixels[i] ? 1 : 0;
    EXPECT_GT(same, with.pixels.size() * 7 / 10);
    EXPECT_LT(same, with.pixels.size());
}

TEST_F(GlassTest, NothingChangesWithoutASightLineOrWhenTheBodyIsBehindIt) {
    Scene scene = ballUnderPlate();
    scene.objects[kPlate].glassAbove.reset();
    const Image solid = draw(scene);
    scene.objects[kPlate].glassAbove = kAllGlass;
    scene.sight = SightLine{Vec3(0, 0, 12), Vec3(0, 0, 13), 1};
    EXPECT_EQ(draw(scene).pixels, solid.pixels);
    scene.sight.reset();
    EXPECT_EQ(draw(scene).pixels, solid.pixels);
}

TEST_F(GlassTest, OnlyThePartAboveItsHeightTurnsToGlass) {
    Scene scene = ballUnderPlate();
    scene.objects[kPlate].glassAbove = 20.F;
    const Image low = draw(scene);
    scene.sight.reset();
    EXPECT_EQ(draw(scene).pixels, low.pixels);
}

TEST_F(GlassTest, AnIdPictureHoldsTheObjectsNumbersAndTheTransmissionOfTheGlass) {
    Scene scene = ballUnderPlate();
    const auto ids = renderer().identify(scene, kTestSize, {Vec3(0, 0, 3), 1});
    ASSERT_TRUE(ids) << ids.error().message();
    const Rgba middle = ids->at(kMiddleX, kMiddleY);
    EXPECT_EQ(middle[0], kBall + 1);
    EXPECT_NE(middle[1] & kInBall, 0);
    EXPECT_GT(middle[2], 200) << "one layer of glass";
    EXPECT_LT(middle[2], 255);
    EXPECT_EQ(ids->at(0, 0)[0], 0) << "the background";
    scene.sight.reset();
    const auto solid = renderer().identify(scene, kTestSize);
    ASSERT_TRUE(solid) << solid.error().message();
    EXPECT_EQ(solid->at(kMiddleX, kMiddleY)[0], kPlate + 1);
    EXPECT_EQ(solid->at(kMiddleX, kMiddleY)[2], 255);
}

TEST_F(GlassTest, TheMagnifierShowsItsPlaceLargerInTheUpperLeftCorner) {
    Scene scene = ballUnderPlate();
    scene.objects.pop_back();
    Appearance blue;
    blue.colour = Vec3f(0.1F, 0.1F, 0.9F);
    scene.objects.push_back(test::objectOf(test::sphere(Vec3(0, 0, 3), 0.4, 32, 32), blue));
    const auto bluePixels = [](const Image& image, const CornerRectangle& place) {
        int count = 0;
        for (int y = 0; y < place.size.height; ++y) {
            for (int x = 0; x < place.size.width; ++x) {
                const Rgba& pixel = image.at(place.left + x, place.top + y);
                count += pixel[2] > pixel[0] + 30 ? 1 : 0;
            }
        }
        return count;
    };
    const CornerRectangle lens = magnifierRectangle(kTestSize);
    const Image plain = draw(scene);
    EXPECT_EQ(bluePixels(plain, lens), 0);
    scene.magnified = Vec3(0, 0, 3);
    const Image magnified = draw(scene);
    const CornerRectangle whole{
        lens.left + lens.size.width, 0, {kTestSize.width - lens.left - lens.size.width, kTestSize.height}};
    const double ratio = static_cast<double>(bluePixels(magnified, lens)) / bluePixels(plain, whole);
    EXPECT_NEAR(ratio, kMagnification * kMagnification, 0.25 * kMagnification * kMagnification);
}

}  // namespace
}  // namespace tactooth

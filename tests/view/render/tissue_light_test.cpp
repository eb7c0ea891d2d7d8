// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::meanColour;
using test::objectOf;
using test::sceneOf;

class TissueLight : public test::RendererTest {};

struct HueAndSaturation {
    double hue;  ///< degrees
    double saturation;
};

HueAndSaturation hueOf(const Vec3& colour) {
    const double x = colour.x() - 0.5 * (colour.y() + colour.z());
    const double y = 0.5 * std::sqrt(3.0) * (colour.y() - colour.z());
    return {std::atan2(y, x) * 180 / std::numbers::pi, std::hypot(x, y) / colour.maxCoeff()};
}

TEST_F(TissueLight, ShadedTissueKeepsItsHue) {
    for (const Appearance& appearance : {appearances::enamel(), appearances::dentin(), appearances::gingiva()}) {
        Scene scene = sceneOf({objectOf(test::sphere(Vec3::Zero(), 3, 96, 48), appearance)});
        scene.lighting = operatingLight(scene.camera);
        const HueAndSaturation lit = hueOf(meanColour(draw(scene, kFine)));
        scene.lighting.keyColour = Vec3f::Zero();  // as in the shadow of an instrument
        const HueAndSaturation shaded = hueOf(meanColour(draw(scene, kFine)));
        EXPECT_NEAR(shaded.hue, lit.hue, 14);
        EXPECT_GT(shaded.saturation, 0.7 * lit.saturation);
    }
}

/// Correlation of the brightness in the middle of the picture with that `shift` pixels to the right.
double correlation(const Image& image, int shift) {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    int count = 0;
    for (int y = 20; y < 220; ++y) {
        for (int x = 20; x < 300 - shift; ++x, ++count) {
            const double left = image.at(x, y)[1], right = image.at(x + shift, y)[1];
            a += left;
            b += right;
            aa += left * left;
            bb += right * right;
            ab += left * right;
        }
    }
    const double covariance = ab / count - a / count * b / count;
    return covariance / std::sqrt((aa / count - a / count * a / count) * (bb / count - b / count * b / count));
}

TEST_F(TissueLight, StipplesOfTheGumFollowNoPattern) {
    Scene scene = sceneOf({objectOf(test::box(Vec3(-20, -20, -1), Vec3(20, 20, 0)), appearances::gingiva())});
    scene.camera.cameraInWorld = {Vec3(0, 0, 60), Quat::Identity()};
    scene.camera.fieldOfView = 2 * std::atan(6.0 / 60);  // 12 mm: 20 pixels a millimetre
    scene.lighting.toKey = Vec3(0.6, 0.2, 0.8).normalized();
    const Image image = draw(scene, kFine);
    EXPECT_GT(correlation(image, 1), 0.5) << "there are stipples, larger than a pixel";
    for (int shift = 24; shift < 160; ++shift) EXPECT_LT(correlation(image, shift), 0.45) << shift / 20.0 << " mm";
}

TEST_F(TissueLight, GroovesAreNotBrown) {
    // Two balls that touch: the groove between them at rest, against the same without occlusion.
    Scene scene =
        sceneOf({objectOf(test::sphere(Vec3(-2, 0, 0), 2, 96, 48)), objectOf(test::sphere(Vec3(2, 0, 0), 2, 96, 48))},
                {1.5707963, 0.3});
    scene.lighting = operatingLight(scene.camera);
    RenderSettings open = kFine;
    open.ambientOcclusion = false;
    const Vec3 with = meanColour(draw(scene, kFine)), without = meanColour(draw(scene, open));
    EXPECT_LT(with.y(), without.y());
    EXPECT_NEAR(hueOf(with).hue, hueOf(without).hue, 3);
    EXPECT_NEAR(hueOf(with).saturation, hueOf(without).saturation, 0.02);
}

TEST_F(TissueLight, ThePictureHardlyChangesWhenItComesToRest) {
    Scene scene = sceneOf({objectOf(test::sphere(Vec3::Zero(), 3, 96, 48)),
                           objectOf(test::box(Vec3(-8, -8, -4), Vec3(8, 8, -3.5)), appearances::gingiva())},
                          {1.0, 0.9});
    scene.lighting = operatingLight(scene.camera);
    EXPECT_LT(compare(draw(scene, kQuick), draw(scene, kFine)).mean, 3.0);
}

}  // namespace
}  // namespace tactooth

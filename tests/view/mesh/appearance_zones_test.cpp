// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/appearance_zones.h"

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "view/mesh/patch_shading.h"

namespace tactooth {
namespace {

/// Tag 0 passes into tag 5 with the height, on walls of a cut into tag 6; tag 1 is always 7.
class ByHeight : public AppearanceZones {
public:
    [[nodiscard]] AppearanceMix at(const Place& place) const override {
        if (place.tag == 1) return {7, 7, 0};
        const double share = std::clamp(place.point.z() / 2 + 0.5, 0.0, 1.0);
        return {0, static_cast<SurfaceTag>(place.isCut ? 6 : 5), static_cast<std::uint8_t>(255 * share)};
    }
};

TEST(AppearanceZones, EachVertexHasTheMixOfItsPlace) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 1, 24, 12);
    CornerShading shading = cornerShading(ball);
    applyZones(ByHeight(), ball, shading);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const AppearanceMix& mix = shading.appearances[3 * t + static_cast<std::size_t>(c)];
            EXPECT_EQ(mix.second, 5);
            EXPECT_NEAR(mix.share, 255 * (ball.corner(t, c).z() / 2 + 0.5), 1.5);
        }
    }
}

TEST(AppearanceZones, WhereTwoTagsMeetEachIsWhatIsStrongestInItsZone) {
    const ByHeight zones;
    const AppearanceMix low = zonedMix(zones, {0, 1, 100}, {.point = Vec3(0, 0, -1)});
    EXPECT_EQ(low, (AppearanceMix{0, 7, 100}));
    const AppearanceMix high = zonedMix(zones, {0, 1, 100}, {.point = Vec3(0, 0, 1)});
    EXPECT_EQ(high, (AppearanceMix{5, 7, 100}));
}

TEST(AppearanceZones, WallsOfACutHaveTheirOwn) {
    const SurfacePart base(test::sphere(Vec3::Zero(), 3, 24, 12));
    const CornerShading baseShading = cornerShading(base.mesh());
    const TriangleMesh cut = test::box(Vec3(-0.5, -0.5, -0.5), Vec3(0.5, 0.5, 0.5));
    const ShadedPatch patch(std::make_shared<const SurfacePart>(cut), base, baseShading);
    const ByHeight zones;
    const CornerShading shading = patchShading(patch, {}, base, baseShading, &zones);
    for (const AppearanceMix& mix : shading.appearances) EXPECT_EQ(mix.second, 6);
}

}  // namespace
}  // namespace tactooth

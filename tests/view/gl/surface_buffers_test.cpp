// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/surface_buffers.h"

#include <gtest/gtest.h>

#include "support/shapes.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

using test::coveredPixelCount;

class SurfaceBuffersTest : public test::RendererTest {
protected:
    /// A plate seen from above; the upper half of its triangles has tag 1.
    static std::shared_ptr<const SurfacePart> plate() {
        TriangleMesh mesh;
        std::vector<SurfaceTag> tags;
        constexpr std::uint32_t kCells = 20;
        for (std::uint32_t y = 0; y <= kCells; ++y) {
            for (std::uint32_t x = 0; x <= kCells; ++x) {
                mesh.vertices.push_back(Vec3f(static_cast<float>(x), static_cast<float>(y), 0) * 0.2F);
            }
        }
        for (std::uint32_t y = 0; y < kCells; ++y) {
            for (std::uint32_t x = 0; x < kCells; ++x) {
                const std::uint32_t corner = y * (kCells + 1) + x;
                mesh.triangles.push_back({corner, corner + 1, corner + kCells + 2});
                mesh.triangles.push_back({corner, corner + kCells + 2, corner + kCells + 1});
                tags.insert(tags.end(), 2, y < kCells / 2 ? SurfaceTag{0} : SurfaceTag{1});
            }
        }
        return std::make_shared<const SurfacePart>(std::move(mesh), std::move(tags));
    }

    using Part = std::shared_ptr<const SurfacePart>;

    static Surface surfaceOf(const Part& base, std::vector<Part> patches = {}) {
        Surface surface;
        surface.base = base;
        surface.patches = std::move(patches);
        return surface;
    }

    /// `base` without its first `count` triangles.
    static Surface withoutFirst(const Part& base, std::uint32_t count) {
        Surface surface = surfaceOf(base);
        surface.hidden = hiding(*base, 0, count);
        return surface;
    }

    static Scene sceneOf(const Surface& surface) {
        SceneObject tooth;
        tooth.shape = std::make_shared<const Surface>(surface);
        tooth.appearances = {appearances::enamel(), appearances::pulp()};
        return test::sceneOf({tooth}, {-1.5707963, 1.5707963});
    }

    static Rgba colourAt(const Scene& scene, const Image& image, const Vec3& point) {
        const Vec2 place = project(scene.camera, test::kTestSize, point).value();
        return image.at(static_cast<int>(place.x()), static_cast<int>(place.y()));
    }

    static std::shared_ptr<const TriangleMask> hiding(const SurfacePart& part, std::uint32_t first,
                                                      std::uint32_t count) {
        auto mask = std::make_shared<TriangleMask>((part.mesh().triangles.size() + 63) / 64);
        for (std::uint32_t t = first; t < first + count; ++t) (*mask)[t / 64] |= std::uint64_t{1} << (t % 64);
        return mask;
    }
};

TEST_F(SurfaceBuffersTest, TagsChooseTheAppearance) {
    const Scene scene = sceneOf(surfaceOf(plate()));
    const Image image = draw(scene);
    const Rgba enamel = colourAt(scene, image, Vec3(2, 1, 0));
    const Rgba pulp = colourAt(scene, image, Vec3(2, 3, 0));
    EXPECT_LT(int{enamel[0]} - int{enamel[2]}, 50);
    EXPECT_GT(int{pulp[0]}, 2 * int{pulp[2]});
}

TEST_F(SurfaceBuffersTest, HiddenTrianglesVanishAndComeBack) {
    const auto base = plate();
    const std::size_t whole = coveredPixelCount(draw(sceneOf(surfaceOf(base))));
    Scene scene = sceneOf(withoutFirst(base, 400));
    const Image half = draw(scene);
    EXPECT_EQ(renderer().lastUpload(), 400U);
    EXPECT_NEAR(static_cast<double>(coveredPixelCount(half)), 0.5 * static_cast<double>(whole),
                0.02 * static_cast<double>(whole));
    EXPECT_EQ(colourAt(scene, half, Vec3(2, 1, 0))[3], 0);
    scene = sceneOf(surfaceOf(base));
    EXPECT_EQ(coveredPixelCount(draw(scene)), whole);
    EXPECT_EQ(renderer().lastUpload(), 400U);
}

TEST_F(SurfaceBuffersTest, PatchesAppearOnceAndOnlyNewOnesAreSent) {
    const auto base = plate();
    const auto pit = std::make_shared<const SurfacePart>(test::box(Vec3(1, 1, 0), Vec3(1.5, 1.5, 0.3)),
                                                         std::vector<SurfaceTag>(12, 1));
    const auto second = std::make_shared<const SurfacePart>(test::box(Vec3(2, 1, 0), Vec3(2.5, 1.5, 0.3)));
    draw(sceneOf(surfaceOf(base)));
    Scene scene = sceneOf(surfaceOf(base, {pit}));
    const Rgba red = colourAt(scene, draw(scene), Vec3(1.25, 1.25, 0.3));
    EXPECT_GT(int{red[0]}, 2 * int{red[2]});
    EXPECT_EQ(renderer().lastUpload(), 12U);
    scene = sceneOf(surfaceOf(base, {pit, second}));
    draw(scene);
    EXPECT_EQ(renderer().lastUpload(), 12U);
    scene = sceneOf(surfaceOf(base, {second}));
    const Rgba white = colourAt(scene, draw(scene), Vec3(1.25, 1.25, 0.0));
    EXPECT_LT(int{white[0]}, 2 * int{white[2]});
    EXPECT_EQ(renderer().lastUpload(), 0U);
}

TEST_F(SurfaceBuffersTest, MorePatchesThanTheFirstBuffersHold) {
    const auto base = plate();
    Surface surface = surfaceOf(base);
    for (int i = 0; i < 40; ++i) {
        const Vec3 centre(0.1 * i, 2, 0.5);
        surface.patches.push_back(std::make_shared<const SurfacePart>(test::sphere(centre, 0.4, 24, 24)));
    }
    const Scene scene = sceneOf(surface);
    const Image all = draw(scene);
    for (int i = 0; i < 40; i += 3) EXPECT_EQ(colourAt(scene, all, Vec3(0.1 * i, 2, 0.9))[3], 255);
    EXPECT_EQ(renderer().lastUpload(), 800U + 40U * 24U * 23U * 2U);
}

/// A ball of 48,000 triangles, a hole in it, and the rim of the hole: they appear the same whether drawn in full or
/// not.
TEST_F(SurfaceBuffersTest, CoarsePictureOfAHurtSurfaceIsThatOfTheTrueOne) {
    const auto ball = std::make_shared<const SurfacePart>(test::sphere(Vec3::Zero(), 4, 200, 120));
    Surface surface = surfaceOf(ball);
    Scene scene = sceneOf(surface);
    for (const std::uint32_t first : {0U, 9000U, 30000U}) {
        surface.hidden = hiding(*ball, first, 2500);
        scene.objects[0].shape = std::make_shared<const Surface>(surface);
        const Image coarse = draw(scene, {.shadows = Shadows::None, .lodTolerance = 0.5});
        const Image full = draw(scene, {.shadows = Shadows::None, .lodTolerance = 0});
        EXPECT_NE(coarse, full) << first;
        const ImageDifference difference = compare(coarse, full);
        EXPECT_LT(difference.mean, 1.0) << first;
        EXPECT_LT(difference.worstShare, 0.01) << first;
    }
}

TEST_F(SurfaceBuffersTest, TwoSnapshotsOfOneToothInOneScene) {
    const auto base = plate();
    Scene scene = sceneOf(surfaceOf(base));
    SceneObject cut = scene.objects[0];
    cut.shape = std::make_shared<const Surface>(withoutFirst(base, 800));
    cut.objectInWorld.position = Vec3(0, 0, 1);
    scene.objects.push_back(cut);
    const Image first = draw(scene);
    EXPECT_EQ(first, draw(scene));
    EXPECT_EQ(renderer().lastUpload(), 0U);
    EXPECT_EQ(colourAt(scene, first, Vec3(2, 1, 0))[3], 255);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "view/camera/orbit_camera.h"
#include "view/render/offscreen.h"

namespace tactooth::test {

inline constexpr ImageSize kTestSize{320, 240};

/// A renderer that all pictures of a test program share, because it takes a while to make one.
class RendererTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        auto made = OffscreenRenderer::create();
        ASSERT_TRUE(made) << made.error().message();
        renderer_.emplace(std::move(*made));
    }
    static void TearDownTestSuite() { renderer_.reset(); }

    static Image draw(const Scene& scene, const RenderSettings& settings = kQuick, ImageSize size = kTestSize) {
        auto image = renderer_->render(scene, size, settings);
        EXPECT_TRUE(image) << image.error().message();
        return image ? std::move(*image)
                     : Image{size, std::vector<Rgba>(static_cast<std::size_t>(size.width * size.height))};
    }
    static OffscreenRenderer& renderer() { return *renderer_; }

private:
    static inline std::optional<OffscreenRenderer> renderer_;
};

inline SceneObject objectOf(TriangleMesh mesh, const Appearance& appearance = appearances::enamel()) {
    SceneObject object;
    object.shape = std::make_shared<const TriangleMesh>(std::move(mesh));
    object.appearances = {appearance};
    return object;
}

/// A scene on a transparent background, seen from `direction`. Opacity then separates the object from the background.
inline Scene sceneOf(std::vector<SceneObject> objects, OrbitCamera::Direction direction = {0.9, 0.5}) {
    Scene scene;
    scene.objects = std::move(objects);
    scene.background.kind = Background::Kind::Transparent;
    OrbitCamera camera;
    camera.fit(boundingBox(scene), kTestSize.aspect());
    camera.setView(direction);
    scene.camera = camera.camera();
    return scene;
}

inline std::size_t coveredPixelCount(const Image& image) {
    return static_cast<std::size_t>(
        std::count_if(image.pixels.begin(), image.pixels.end(), [](const Rgba& pixel) { return pixel[3] == 255; }));
}

/// Mean colour of the covered pixels, 0..255.
inline Vec3 meanColour(const Image& image) {
    Vec3 sum = Vec3::Zero();
    for (const Rgba& pixel : image.pixels) {
        if (pixel[3] == 255) sum += Vec3(pixel[0], pixel[1], pixel[2]);
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, coveredPixelCount(image)));
}

}  // namespace tactooth::test

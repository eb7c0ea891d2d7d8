// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "view/renderer_fixture.h"

namespace tactooth::test {

// Other drivers round differently and place samples elsewhere. A mean of one grey level and one pixel in a hundred
// (edges) is below the limit of human vision. Any real change of appearance or shape is far above it.
inline constexpr double kMeanTolerance = 1.0;
inline constexpr double kShareTolerance = 0.01;

/// Compares drawn pictures with stored ones.
class Pictures : public RendererTest {
protected:
    static void expectBaseline(const std::string& name, const Scene& scene, const RenderSettings& settings = kFine,
                               ImageSize size = kTestSize) {
        const std::filesystem::path baseline = std::filesystem::path(TACTOOTH_BASELINES) / (name + ".png");
        const Image image = draw(scene, settings, size);
        if (std::getenv("TACTOOTH_UPDATE_BASELINES") != nullptr) {
            ASSERT_TRUE(writePng(image, baseline));
            GTEST_SKIP() << "renewed " << baseline;
        }
        const auto wanted = readPng(baseline);
        ASSERT_TRUE(wanted) << wanted.error().message();
        ASSERT_EQ(wanted->size, image.size);
        const ImageDifference difference = compare(image, *wanted);
        const bool same = difference.mean < kMeanTolerance && difference.worstShare < kShareTolerance;
        const std::string seen = name + "-seen.png";
        if (!same) {
            ASSERT_TRUE(writePng(image, seen));
        }
        EXPECT_TRUE(same) << "mean difference " << difference.mean << ", visible in a share of "
                          << difference.worstShare << " of the pixels; the picture is in "
                          << std::filesystem::absolute(seen);
    }

    static Scene lit(std::vector<SceneObject> objects, OrbitCamera::Direction direction) {
        Scene scene = sceneOf(std::move(objects), direction);
        scene.background = Background{};
        scene.lighting = operatingLight(scene.camera);
        return scene;
    }
};

}  // namespace tactooth::test

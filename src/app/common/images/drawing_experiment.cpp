// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/images/drawing_experiment.h"

#include <algorithm>
#include <numbers>

#include "experiments/published.h"
#include "experiments/quantile.h"
#include "experiments/thread_clock.h"
#include "geometry/util/number_text.h"
#include "view/camera/orbit_camera.h"
#include "view/render/offscreen.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{1280, 800};
constexpr int kPictures = 9;
constexpr int kWarmUp = 2;  // frames in which shapes are uploaded to the graphics card

/// Median time of a frame, ms, while the camera moves by one degree per frame.
Expected<double> timeDrawing(OffscreenRenderer& renderer, const TriangleMesh& mesh) {
    Scene scene;
    SceneObject tooth;
    tooth.shape = std::make_shared<const TriangleMesh>(mesh);
    tooth.appearances = {appearances::enamel()};
    scene.objects = {tooth};
    std::vector<double> times;
    for (int i = 0; i < kPictures + kWarmUp; ++i) {
        OrbitCamera camera;
        camera.fit(boundingBox(mesh), kSize.aspect());
        camera.setView({std::numbers::pi / 180 * i, 0.6});
        scene.camera = camera.camera();
        const double start = wallMillis();
        const auto image = renderer.render(scene, kSize, kQuick);
        if (!image) return Unexpected{image.error()};
        if (i >= kWarmUp) times.push_back(wallMillis() - start);
    }
    return quantile(times, 0.5);
}

}  // namespace

Expected<Experiment> measureDrawing(TestTeeth& testTeeth) {
    auto renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    Experiment experiment{"table3", "Drawing", "", {"tooth", "percent", "triangles", "picture_ms"}, {}, 1, {}, {}};
    experiment.method =
        "A lit picture of 1280 x 800 pixels with the shadow of the operating light, drawn without a window and read "
        "back, while the camera turns. Median of nine pictures, wall time. Drawn by: " +
        renderer->device() + ".";
    ExperimentPlot panel{"Time of a picture", "triangles", "ms", true, true, {}};
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    const auto add = [&](const std::string& name, int percent, const TriangleMesh& mesh,
                         PlotSeries& series) -> Expected<void> {
        const auto time = timeDrawing(*renderer, mesh);
        if (!time) return Unexpected{time.error()};
        const auto triangles = static_cast<double>(mesh.triangles.size());
        experiment.rows.push_back({name, static_cast<double>(percent), triangles, *time});
        series.points.push_back({triangles, *time});
        shortest = std::min(shortest, *time);
        longest = std::max(longest, *time);
        return {};
    };
    PlotSeries bur{"bur", {}, true, false};
    if (const auto done = add("bur", 100, testTeeth.bur()->mesh(), bur); !done) return Unexpected{done.error()};
    panel.series.push_back(bur);
    for (const StandardToothKind kind : kStandardTeeth) {
        const auto ladder = testTeeth.ladder(kind);
        if (!ladder) return Unexpected{ladder.error()};
        PlotSeries series{(*testTeeth.tooth(kind))->name, {}, true, false};
        for (const Resolution& resolution : **ladder) {
            const auto done = add(series.name, resolution.percent, resolution.mesh, series);
            if (!done) return Unexpected{done.error()};
        }
        panel.series.push_back(series);
    }
    using namespace published;
    panel.series.push_back({"published", {{kMinTriangles, kShortestDraw}, {kMaxTriangles, kLongestDraw}}, true, true});
    experiment.panels.push_back(panel);
    experiment.comparisons = {
        {"Shortest time of a picture", numberText(kShortestDraw) + " ms", shortNumber(shortest) + " ms"},
        {"Longest time of a picture", numberText(kLongestDraw) + " ms", shortNumber(longest) + " ms"}};
    return experiment;
}

}  // namespace tactooth

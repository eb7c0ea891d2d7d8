// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/frame_timer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>
#include <vector>

#include "view/egl_context.h"
#include "view/render_target.h"
#include "view/renderer.h"
#include "view/shader_program.h"
#include "view/shaders.h"
#include "view/shape_cache.h"

namespace tactooth {

namespace {

constexpr int kUnmeasured = 2;  // the first pictures upload the shapes and compile what the driver had put off

constexpr std::string_view kOneColour =
    "layout(location = 0) out vec4 fragment;\nvoid main() { fragment = vec4(0.8, 0.78, 0.7, 1.0); }\n";

double processorMs() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

/// What is kept of one reel while the others have their turns.
struct Turn {
    Renderer renderer;
    ShapeCache shapes;  // of bare pictures
    std::vector<double> wall = {}, processor = {};
};

}  // namespace

struct FrameTimer::Parts {
    EglContext context;  // first: all others need it to the end
    ShaderProgram oneColour;
    RenderTarget target;

    Expected<void> drawBare(const Scene& scene, ShapeCache& shapes);
    Expected<void> draw(const Reel& reel, int picture, Turn& turn);
};

Expected<void> FrameTimer::Parts::drawBare(const Scene& scene, ShapeCache& shapes) {
    const ShapeCache::Result result = shapes.update(scene);
    target.bindForDrawing();
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    oneColour.use();
    const Mat4 worldToClip = projectionMatrix(scene.camera, target.size().aspect()) * viewMatrix(scene.camera);
    for (const Drawable& drawable : result.drawables) {
        const Mat4 objectToClip = worldToClip * drawable.objectToWorld;
        oneColour.set("objectToClip", objectToClip);
        drawable.buffers->draw({objectToClip, Eigen::Vector4d::Zero(), false});
    }
    return gl::checkErrors("drawing in one colour");
}

Expected<void> FrameTimer::Parts::draw(const Reel& reel, int picture, Turn& turn) {
    const auto begin = std::chrono::steady_clock::now();
    const double processorBegin = processorMs();
    const Scene scene = reel.film(picture);
    Expected<void> done = reel.settings
                              ? turn.renderer.render(scene, target.framebuffer(), target.size(), *reel.settings)
                              : drawBare(scene, turn.shapes);
    if (!done) return done;
    glFinish();
    if (picture < 0) return {};
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    turn.wall.push_back(passed.count());
    turn.processor.push_back(processorMs() - processorBegin);
    return {};
}

Expected<FrameTimer> FrameTimer::create(PictureSize size) {
    auto context = EglContext::create();
    if (!context) return Unexpected{context.error()};
    auto program = ShaderProgram::create("one colour", "", {shaders::kDepthVert}, {kOneColour});
    if (!program) return Unexpected{program.error()};
    auto target = RenderTarget::create(size, 0);
    if (!target) return Unexpected{target.error()};
    return FrameTimer(std::unique_ptr<Parts>(new Parts{std::move(*context), std::move(*program), std::move(*target)}));
}

FrameTimer::FrameTimer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
FrameTimer::FrameTimer(FrameTimer&&) noexcept = default;
FrameTimer& FrameTimer::operator=(FrameTimer&&) noexcept = default;
FrameTimer::~FrameTimer() = default;

std::string FrameTimer::device() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

Expected<std::vector<FrameTimes>> FrameTimer::inTurn(const std::vector<Reel>& reels, int frames) {
    std::vector<Turn> turns;
    for (std::size_t i = 0; i < reels.size(); ++i) {
        auto renderer = Renderer::create();
        if (!renderer) return Unexpected{renderer.error()};
        turns.push_back({std::move(*renderer), {}});
    }
    for (int picture = -kUnmeasured; picture < frames; ++picture) {
        for (std::size_t i = 0; i < reels.size(); ++i) {
            if (const auto done = parts_->draw(reels[i], picture, turns[i]); !done) return Unexpected{done.error()};
        }
    }
    std::vector<FrameTimes> times;
    for (const Turn& turn : turns) {
        times.push_back({mean(turn.wall), quantile(turn.wall, 0.99), mean(turn.processor)});
    }
    return times;
}

}  // namespace tactooth

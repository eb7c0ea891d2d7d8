// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/frame_timer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
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

double quantile(std::vector<double> values, double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

template <class Draw>
Expected<FrameTimes> timed(const FrameTimer::Film& film, int frames, const Draw& draw) {
    std::vector<double> wall, processor;
    for (int i = -kUnmeasured; i < frames; ++i) {
        const Scene scene = film(i);
        const auto begin = std::chrono::steady_clock::now();
        const double processorBegin = processorMs();
        if (Expected<void> done = draw(scene); !done) return Unexpected{done.error()};
        glFinish();
        if (i < 0) continue;
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
        wall.push_back(passed.count());
        processor.push_back(processorMs() - processorBegin);
    }
    return FrameTimes{quantile(wall, 0.5), quantile(wall, 0.99), quantile(processor, 0.5)};
}

}  // namespace

struct FrameTimer::Parts {
    EglContext context;  // first: all others need it to the end
    Renderer renderer;
    ShaderProgram oneColour;
    ShapeCache shapes;
    RenderTarget target;

    Expected<void> drawBare(const Scene& scene);
};

Expected<void> FrameTimer::Parts::drawBare(const Scene& scene) {
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

Expected<FrameTimer> FrameTimer::create(PictureSize size) {
    auto context = EglContext::create();
    if (!context) return Unexpected{context.error()};
    auto renderer = Renderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    auto program = ShaderProgram::create("one colour", "", {shaders::kDepthVert}, {kOneColour});
    if (!program) return Unexpected{program.error()};
    auto target = RenderTarget::create(size, 0);
    if (!target) return Unexpected{target.error()};
    return FrameTimer(std::unique_ptr<Parts>(
        new Parts{std::move(*context), std::move(*renderer), std::move(*program), {}, std::move(*target)}));
}

FrameTimer::FrameTimer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
FrameTimer::FrameTimer(FrameTimer&&) noexcept = default;
FrameTimer& FrameTimer::operator=(FrameTimer&&) noexcept = default;
FrameTimer::~FrameTimer() = default;

std::string FrameTimer::device() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

Expected<FrameTimes> FrameTimer::full(const Film& film, int frames, const RenderSettings& settings) {
    return timed(film, frames, [&](const Scene& scene) {
        return parts_->renderer.render(scene, parts_->target.framebuffer(), parts_->target.size(), settings);
    });
}

Expected<FrameTimes> FrameTimer::bare(const Film& film, int frames) {
    return timed(film, frames, [&](const Scene& scene) { return parts_->drawBare(scene); });
}

}  // namespace tactooth

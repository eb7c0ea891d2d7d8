// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/render/frame_timer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>
#include <utility>
#include <vector>

#include "view/gl/egl_context.h"
#include "view/gl/messages.h"
#include "view/gl/render_target.h"
#include "view/gl/shader_program.h"
#include "view/gl/shaders.h"
#include "view/gl/shape_cache.h"
#include "view/render/renderer.h"

namespace tactooth {

namespace {

constexpr int kRun = 8;         // frames in a row: enough that the wait at their end has little weight
constexpr int kUnmeasured = 2;  // the first frames upload the shapes and compile what the driver had deferred

constexpr std::string_view kOneColour =
    "layout(location = 0) out vec4 fragment;\nvoid main() { fragment = vec4(0.8, 0.78, 0.7, 1.0); }\n";

double processorMs() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double wallMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double quantile(std::vector<double> values, double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
    return values[place];
}

/// The stored state of one candidate while the other candidates have their turns.
struct Turn {
    Renderer renderer;
    ShapeCache shapes;  // for frames without `settings`
    std::vector<double> wall = {}, processor = {};
    double runs = 0;  // total time of all runs, ms
};

/// Signals when all earlier OpenGL commands are complete.
class Fence {
public:
    Fence() = default;
    Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Fence& operator=(Fence&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence() {
        if (sync_ != nullptr) glDeleteSync(sync_);
    }
    void set() { sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0); }
    void wait() const {
        constexpr GLuint64 kLong = 1'000'000'000;  // ns
        while (sync_ != nullptr && glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, kLong) == GL_TIMEOUT_EXPIRED) {
        }
    }

private:
    GLsync sync_ = nullptr;
};

}  // namespace

struct FrameTimer::Parts {
    EglContext context;  // first member: all others need it until they are destroyed
    ShaderProgram oneColour;
    RenderTarget target;

    Expected<void> drawBare(const Scene& scene, ShapeCache& shapes);
    Expected<void> draw(const Candidate& candidate, int picture, Turn& turn);
    Expected<void> timeOne(const Candidate& candidate, int picture, Turn& turn);
    Expected<void> timeRun(const Candidate& candidate, int first, int end, Turn& turn);
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
    return gl::checkErrors(msg::kDrawingColour);
}

Expected<void> FrameTimer::Parts::draw(const Candidate& candidate, int picture, Turn& turn) {
    const Scene scene = candidate.sequence(picture);
    return candidate.settings ? turn.renderer.render(scene, target.framebuffer(), target.size(), *candidate.settings)
                              : drawBare(scene, turn.shapes);
}

Expected<void> FrameTimer::Parts::timeOne(const Candidate& candidate, int picture, Turn& turn) {
    const double begin = wallMs();
    const double processorBegin = processorMs();
    if (const auto done = draw(candidate, picture, turn); !done) return done;
    glFinish();
    if (picture < 0) return {};
    turn.wall.push_back(wallMs() - begin);
    turn.processor.push_back(processorMs() - processorBegin);
    return {};
}

Expected<void> FrameTimer::Parts::timeRun(const Candidate& candidate, int first, int end, Turn& turn) {
    const double begin = wallMs();
    Fence before;
    for (int picture = first; picture < end; ++picture) {
        if (const auto done = draw(candidate, picture, turn); !done) return done;
        Fence drawn;
        drawn.set();
        before.wait();
        before = std::move(drawn);
    }
    before.wait();
    turn.runs += wallMs() - begin;
    return {};
}

Expected<FrameTimer> FrameTimer::create(ImageSize size) {
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

std::string FrameTimer::device() const { return rendererName(); }

Expected<std::vector<FrameTimes>> FrameTimer::measureInterleaved(const std::vector<Candidate>& candidates, int frames) {
    std::vector<Turn> turns;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        auto renderer = Renderer::create();
        if (!renderer) return Unexpected{renderer.error()};
        turns.push_back({std::move(*renderer), {}});
    }
    for (int picture = -kUnmeasured; picture < frames; ++picture) {
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (const auto done = parts_->timeOne(candidates[i], picture, turns[i]); !done)
                return Unexpected{done.error()};
        }
    }
    for (int first = 0; first < frames; first += kRun) {
        const int end = std::min(frames, first + kRun);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (const auto done = parts_->timeRun(candidates[i], first, end, turns[i]); !done) {
                return Unexpected{done.error()};
            }
        }
    }
    std::vector<FrameTimes> times;
    for (const Turn& turn : turns) {
        times.push_back({mean(turn.wall), quantile(turn.wall, 0.99), mean(turn.processor), 1000 * frames / turn.runs});
    }
    return times;
}

}  // namespace tactooth

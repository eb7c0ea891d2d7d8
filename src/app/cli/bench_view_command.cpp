// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench_view_command.h"

#include <fmt/core.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/bench_mouth.h"
#include "app/cli/exit_code.h"
#include "app/cli/render_words.h"
#include "session/experiments/run_facts.h"
#include "session/experiments/standard_teeth.h"
#include "view/frame_timer.h"
#include "view/orbit_camera.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStep = std::numbers::pi / 180;  // the eye goes on by a degree from picture to picture

struct Case {
    std::string name;
    std::string what;
    bool bare;
    RenderSettings settings;
    const Scene* scene;
    OrbitCamera eye;
};

FrameTimer::Film filmOf(const Case& one) {
    return [&one](int i) {
        Scene scene = *one.scene;
        OrbitCamera eye = one.eye;
        eye.look({one.eye.direction().azimuth + kStep * i, one.eye.direction().elevation});
        scene.camera = eye.camera();
        scene.lighting = operatingLight(scene.camera);
        return scene;
    };
}

Scene toothScene(const TriangleMesh& mesh) {
    SceneObject object;
    object.shape = std::make_shared<const TriangleMesh>(mesh);
    object.looks = {looks::enamel()};
    Scene scene;
    scene.objects.push_back(std::move(object));
    return scene;
}

std::size_t trianglesOf(const Scene& scene) {
    std::size_t sum = 0;
    for (const SceneObject& object : scene.objects) {
        sum += std::get<std::shared_ptr<const TriangleMesh>>(object.shape)->triangles.size();
    }
    return sum;
}

std::vector<Case> casesOf(const Scene& tooth, const Scene& mouth, PictureSize size) {
    OrbitCamera atTooth, atMouth;
    atTooth.fit(boundingBox(tooth), size.aspect());
    atTooth.look({1.25, 0.62});
    atMouth.fit(Box3(Vec3(-32, -52, -45), Vec3(32, 6, 12)), size.aspect());
    atMouth.look({1.57, 0.4});
    return {{"tooth", "bare, in one colour", true, {}, &tooth, atTooth},
            {"tooth", "light and shadow", false, kQuick, &tooth, atTooth},
            {"tooth", "all of it", false, kFine, &tooth, atTooth},
            {"mouth", "bare, in one colour", true, {}, &mouth, atMouth},
            {"mouth", "light, shadow, mirror", false, kQuick, &mouth, atMouth}};
}

Expected<void> measure(const BenchViewOptions& options) {
    const auto size = parseSize(options.size);
    if (!size) return Unexpected{size.error()};
    const auto tooth = options.mouth           ? Expected<StandardTooth>(StandardTooth())
                       : options.tooth.empty() ? standardTooth(StandardToothKind::Large)
                                               : ownTooth(options.tooth);
    if (!tooth) return Unexpected{tooth.error()};
    auto timer = FrameTimer::create(*size);
    if (!timer) return Unexpected{timer.error()};
    const RunFacts facts = currentRunFacts();
    Json json = {{"machine", facts.machine}, {"compiler", facts.compiler}, {"commit", facts.commit},
                 {"command", facts.command}, {"date", facts.date},         {"opengl", timer->device()},
                 {"width", size->width},     {"height", size->height},     {"cases", Json::array()}};
    if (!options.json) {
        fmt::print("machine:  {}\ncommit:   {}\ncommand:  {}\nOpenGL:   {}\n", facts.machine, facts.commit,
                   facts.command, timer->device());
        fmt::print("{} x {} pixels, the eye turns by a degree a picture; ms, the middle of {} pictures\n\n",
                   size->width, size->height, options.frames);
        fmt::print("{:<7} {:<22} {:>9} {:>9} {:>9} {:>10} {:>7} {:>10}\n", "scene", "drawn", "triangles", "wall", "p99",
                   "processor", "1/s", "of bare");
    }
    const Scene oneTooth = toothScene(tooth->mesh);
    const Expected<Scene> mouth = benchMouth();
    if (!mouth) return Unexpected{mouth.error()};
    double bare = 0;
    for (const Case& one : casesOf(oneTooth, *mouth, *size)) {
        if (options.mouth && one.scene != &*mouth) continue;
        const auto times = one.bare ? timer->bare(filmOf(one), options.frames)
                                    : timer->full(filmOf(one), options.frames, one.settings);
        if (!times) return Unexpected{times.error()};
        if (one.bare) bare = times->processor;
        const double ratio = times->processor / bare;
        json["cases"].push_back({{"scene", one.name},
                                 {"drawn", one.what},
                                 {"triangles", trianglesOf(*one.scene)},
                                 {"wall_ms", times->wall},
                                 {"wall_p99_ms", times->wallP99},
                                 {"processor_ms", times->processor},
                                 {"of_bare", ratio}});
        if (options.json) continue;
        fmt::print("{:<7} {:<22} {:>9} {:>9.2f} {:>9.2f} {:>10.2f} {:>7.0f} {:>10.2f}\n", one.name, one.what,
                   trianglesOf(*one.scene), times->wall, times->wallP99, times->processor, 1000 / times->wall, ratio);
        std::fflush(stdout);
    }
    if (options.json) fmt::print("{}\n", json.dump(1, ' ', false, Json::error_handler_t::replace));
    return {};
}

}  // namespace

int runBenchView(const BenchViewOptions& options) {
    const auto done = measure(options);
    return done ? kExitOk : refuse(done.error());
}

}  // namespace tactooth

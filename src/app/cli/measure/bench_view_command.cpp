// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measure/bench_view_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/measure/bench_mouth.h"
#include "app/cli/measure/drilling_scene.h"
#include "app/cli/pictures/render_arguments.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "experiments/standard_teeth.h"
#include "session/io/run_metadata.h"
#include "view/camera/orbit_camera.h"
#include "view/gl/egl_context.h"
#include "view/render/frame_timer.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStep = std::numbers::pi / 180;  // the camera moves on by one degree from frame to frame

/// One line of the table. The other lines of a scene are compared with its first line.
struct Case {
    std::string what;
    FrameTimer::Candidate candidate;
};

/// One scene and the variants in which it is drawn in turn.
struct Subject {
    std::string name;
    std::size_t triangles;
    std::vector<Case> cases;
};

/// The camera orbits around `scene`, and the light follows it.
FrameTimer::SceneSequence turning(const Scene& scene, const OrbitCamera& eye) {
    return [scene, eye](int i) {
        Scene turned = scene;
        OrbitCamera moved = eye;
        moved.setView({eye.direction().azimuth + kStep * i, eye.direction().elevation});
        turned.camera = moved.camera();
        turned.lighting = operatingLight(turned.camera);
        return turned;
    };
}

Scene toothScene(const TriangleMesh& mesh) {
    SceneObject object;
    object.shape = std::make_shared<const TriangleMesh>(mesh);
    object.appearances = {appearances::enamel()};
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

Subject toothSubject(const TriangleMesh& mesh, ImageSize size) {
    const Scene scene = toothScene(mesh);
    OrbitCamera eye;
    eye.fit(boundingBox(scene), size.aspect());
    eye.setView({1.25, 0.62});
    const FrameTimer::SceneSequence sequence = turning(scene, eye);
    return {"tooth",
            trianglesOf(scene),
            {{"bare, in one colour", {sequence, std::nullopt}},
             {"light and shadow", {sequence, kQuick}},
             {"antialiased edges", {sequence, kMoving}},
             {"smooth edges, soft", {sequence, kSmooth}},
             {"all of it", {sequence, kFine}}}};
}

Expected<Subject> mouthSubject(ImageSize size, const RenderSettings& moved) {
    const Expected<Scene> scene = benchMouth(false), whole = benchMouth(true);
    if (!scene) return Unexpected{scene.error()};
    if (!whole) return Unexpected{whole.error()};
    OrbitCamera eye;
    eye.fit(Box3(Vec3(-32, -52, -45), Vec3(32, 6, 12)), size.aspect());
    eye.setView({1.57, 0.4});
    const FrameTimer::SceneSequence sequence = turning(*scene, eye);
    return Subject{"mouth",
                   trianglesOf(*scene),
                   {{"bare, in one colour", {sequence, std::nullopt}},
                    {"light, shadow, mirror", {sequence, moved}},
                    {"with soft tissues", {turning(*whole, eye), moved}}}};
}

/// `moved`: the settings of the window while things move.
Subject workSubject(const std::string& name, const DrillingScene& work, const RenderSettings& moved) {
    return {name,
            work.triangles(),
            {{"bur moves", {work.moving(), moved}},
             {"bur cuts", {work.cutting(), moved}},
             {"with second view", {work.withSecondView(), moved}},
             {"with ghost of target", {work.withGhost(), moved}}}};
}

/// The molar of an exercise, with its target.
Expected<DrillingScene> workOnMolar(ImageSize size, int frames) {
    const Exercise& exercise = *builtinExercise("class-1-46");
    const auto tooth = exerciseTooth(exercise);
    if (!tooth) return Unexpected{tooth.error()};
    const Expected<TriangleMesh> target = idealShape(exercise, *tooth);
    if (!target) return Unexpected{target.error()};
    return DrillingScene::make(*tooth, *target, size, frames);
}

Expected<DrillingScene> workOn(const TriangleMesh& mesh, ImageSize size, int frames) {
    Expected<LayeredTooth> layered = LayeredTooth::make(mesh, {});
    if (!layered) return unexpected(msg::kToothNotCut, layered.error());
    return DrillingScene::make(std::make_shared<const LayeredTooth>(std::move(*layered)), std::nullopt, size, frames);
}

class Report {
public:
    Report(const BenchViewOptions& options, ImageSize size, const std::string& device) : isJson_(options.json) {
        const RunMetadata facts = currentRunMetadata();
        const bool bySoftware = isSoftwareRenderer(device);
        json_ = {{"machine", facts.machine}, {"compiler", facts.compiler}, {"commit", facts.commit},
                 {"command", facts.command}, {"date", facts.date},         {"opengl", device},
                 {"software", bySoftware},   {"width", size.width},        {"height", size.height},
                 {"cases", Json::array()}};
        if (isJson_) return;
        print("machine:  {}\ncommit:   {}\ncommand:  {}\nOpenGL:   {}, {}\n", facts.machine, facts.commit,
              facts.command, device, bySoftware ? "drawn by the processor" : "drawn by a graphics card");
        print("{} x {} pixels; ms, the mean of {} pictures; the ways of one scene take turns\n\n", size.width,
              size.height, options.frames);
        print("{:60} {:>19} {:>18}\n", "", "one at a time, ms", "of first, by");
        print("{:<14} {:<22} {:>9} {:>9} {:>9} {:>9} {:>7} {:>9} {:>9}\n", "scene", "drawn", "triangles", "wall", "p99",
              "processor", "1/s", "processor", "rate");
    }

    void add(const Subject& subject, const std::vector<FrameTimes>& times) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double ratio = times[i].processor / times.front().processor;
            const double slower = times.front().rate / times[i].rate;
            json_["cases"].push_back({{"scene", subject.name},
                                      {"drawn", subject.cases[i].what},
                                      {"triangles", subject.triangles},
                                      {"wall_ms", times[i].wall},
                                      {"wall_p99_ms", times[i].wallP99},
                                      {"processor_ms", times[i].processor},
                                      {"pictures_per_s", times[i].rate},
                                      {"of_first", ratio},
                                      {"of_first_by_rate", slower}});
            if (isJson_) continue;
            print("{:<14} {:<22} {:>9} {:>9.2f} {:>9.2f} {:>9.2f} {:>7.1f} {:>9.2f} {:>9.2f}\n", subject.name,
                  subject.cases[i].what, subject.triangles, times[i].wall, times[i].wallP99, times[i].processor,
                  times[i].rate, ratio, slower);
        }
        std::fflush(stdout);
    }

    void finish() const {
        if (isJson_) print("{}\n", json_.dump(1, ' ', false, Json::error_handler_t::replace));
    }

private:
    bool isJson_;
    Json json_;
};

Expected<void> measure(const BenchViewOptions& options) {
    const auto size = parseSize(options.size);
    if (!size) return Unexpected{size.error()};
    auto timer = FrameTimer::create(*size);
    if (!timer) return Unexpected{timer.error()};
    Report report(options, *size, timer->device());
    const RenderSettings moved = isSoftwareRenderer(timer->device()) ? kMoving : kSmooth;  // as in the window
    const auto add = [&](const Subject& subject) -> Expected<void> {
        std::vector<FrameTimer::Candidate> candidates;
        for (const Case& one : subject.cases) candidates.push_back(one.candidate);
        const auto times = timer->measureInterleaved(candidates, options.frames);
        if (!times) return Unexpected{times.error()};
        report.add(subject, *times);
        return {};
    };
    if (!options.mouth) {
        const auto tooth = options.tooth.empty() ? standardTooth(StandardToothKind::Large) : customTooth(options.tooth);
        if (!tooth) return Unexpected{tooth.error()};
        if (const auto done = add(toothSubject(tooth->mesh, *size)); !done) return done;
        const auto onTooth = workOn(tooth->mesh, *size, options.frames);
        if (!onTooth) return Unexpected{onTooth.error()};
        Subject atWork = workSubject("tooth, work", *onTooth, moved);
        atWork.cases.pop_back();  // this tooth has no target
        if (const auto done = add(atWork); !done) return done;
        const auto onMolar = workOnMolar(*size, options.frames);
        if (!onMolar) return Unexpected{onMolar.error()};
        if (const auto done = add(workSubject("molar, work", *onMolar, moved)); !done) return done;
    }
    const Expected<Subject> mouth = mouthSubject(*size, moved);
    if (!mouth) return Unexpected{mouth.error()};
    if (const auto done = add(*mouth); !done) return done;
    report.finish();
    return {};
}

}  // namespace

int runBenchView(const BenchViewOptions& options) {
    const auto done = measure(options);
    return done ? kExitOk : reportError(done.error());
}

}  // namespace tactooth

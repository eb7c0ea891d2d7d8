// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/hand_trial.h"

#include "assessment/ideal_shape.h"
#include "assessment/messages.h"
#include "assessment/study/messages.h"
#include "geometry/util/number_text.h"
#include "haptics/force_pipeline.h"
#include "haptics/tool_proxy.h"
#include "session/control/surface_ray.h"
#include "session/model/session_bur.h"
#include "session/simulation/session_voxel.h"
#include "session/track/track_tick.h"

namespace tactooth {
namespace {

constexpr double kTick = ToolProxy::kTick;
constexpr int kTicksPerCut = 5;  // the haptic surface follows the cut within 5 ms

Expected<Instrument> instrumentOf(const Exercise& exercise) {
    const auto* number = std::get_if<std::string>(&exercise.bur);
    const std::optional<BurSpec> spec = number != nullptr ? findBur(*number) : std::nullopt;
    if (number != nullptr && !spec) return unexpected(msg::kBurNotInCatalogue, quotedWord(*number));
    Expected<SessionBur> bur =
        spec ? makeSessionBur(*spec) : loadSessionBur(std::get<std::filesystem::path>(exercise.bur));
    if (!bur) return Unexpected{bur.error()};
    return std::move(bur->instrument);
}

/// Depth of each place below the uncut surface along the shaft, mm; negative above it.
std::vector<double> depthsOf(const std::vector<Vec3>& path, const Surface& uncut, const Vec3& outward) {
    std::vector<double> depths;
    for (const Vec3& place : path) {
        const auto hit = firstHit(uncut, {place + kFarAway * outward, -outward});
        depths.push_back(hit ? kFarAway - *hit : 0);  // beside the tooth there is no surface
    }
    return depths;
}

}  // namespace

Expected<StudyScene> studyScene(const Exercise& exercise, Preparation preparation) {
    const auto* plan = std::get_if<PreparationPlan>(&exercise.ideal);
    if (plan == nullptr || plan->crown) return unexpected(msg::kStudyNeedsAPlan, exercise.name);
    const auto planned = tipPaths(*plan, *preparation.tooth);
    if (!planned) return Unexpected{planned.error()};
    std::vector<std::vector<Vec3>> paths;
    for (const BurPath& path : *planned) paths.push_back(path.places);
    Expected<Instrument> instrument = instrumentOf(exercise);
    if (!instrument) return Unexpected{instrument.error()};
    StudyScene scene{std::move(preparation), {std::move(paths), {}, plan->outward}, std::move(*instrument)};
    const Surface uncut{.base = scene.preparation.original};
    for (const std::vector<Vec3>& path : scene.task.paths)
        scene.task.depths.push_back(depthsOf(path, uncut, plan->outward));
    return scene;
}

std::shared_ptr<CutModel> uncutModel(const StudyScene& scene) {
    return std::make_shared<CutModel>(scene.preparation.tooth, kSessionVoxel);
}

HandTrial playHand(const StudyScene& scene, const std::shared_ptr<CutModel>& model, const HandHabits& habits,
                   std::uint64_t seed, const StepwiseSession::EventSink& sink) {
    SyntheticHand hand(routeOf(scene.task, habits, seed), scene.task.outward, habits, seed);
    HapticSettings settings;
    settings.materials = MaterialTable(scene.preparation.tooth->materials());
    StepwiseSession session(model, {scene.instrument, settings, Placement::AtOnce}, sink);
    ForcePipeline pipeline(ForceLimits{});
    HandWorkMeter meter(scene.preparation.axis);
    HandSense sense{0, hand.place()};
    const auto longest = static_cast<std::int64_t>(kLongestTrial / kTick);
    std::int64_t tick = 0;
    for (; tick < longest && !hand.isDone(); ++tick) {
        const double time = kTick * static_cast<double>(tick);
        const Tick now = session.step({hand.move(kTick, sense), 1, true}, kTick, time);
        sense = {pipeline.pass(forceCommandFrom(now), kTick).force().norm(), now.contact.proxy.position};
        meter.add(TrackTick::of(now.time, now));
        if (tick % kTicksPerCut == 0) (void)session.carve();
        session.list();
    }
    session.finish(/*dropsPieces=*/true);
    HandTrial trial;
    trial.isFinished = hand.isDone();
    trial.toothHash = model->hash();
    Preparation preparation = scene.preparation;
    preparation.prepared = std::make_shared<const SurfacePart>(asReadFromFile(*model->surface()));
    PreparationMeasures measures(preparation);
    measures.hasSession = true;
    measures.hand = meter.finish();
    trial.metrics = measureAll(measures);
    return trial;
}

}  // namespace tactooth

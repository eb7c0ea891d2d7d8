// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/demonstration.h"

#include <chrono>

#include "haptics/force_pipeline.h"
#include "haptics/tool_proxy.h"
#include "session/audio/tick_sound.h"
#include "session/scripts/cut_run.h"
#include "session/scripts/scripted_operator.h"

namespace tactooth {
namespace {

constexpr double kTick = ToolProxy::kTick;
constexpr int kTicksPerCut = 5;  // the haptic surface follows the cut within 5 ms
constexpr std::size_t kTouchPhases = 2;

/// The phases approach and touch, stroke, lift, cut, lift, as shares of the length.
std::vector<OperatorPhase> script(const Vec3& middle, double reach, double seconds) {
    const Vec3 left = middle - Vec3(reach, 0, 0);
    const Vec3 right = middle + Vec3(reach, 0, 0);
    return {
        {0.10 * seconds, left, left, 1, 0.6, 0, false}, {0.20 * seconds, left, right, 2, 0.6, 0, false},
        {0.06 * seconds, left, left, 1, 0, 1, true},    {0.56 * seconds, left, right, 6, 1.2, 1, true},
        {0.08 * seconds, left, left, 1, 0, 0, true},
    };
}

SprayInput sprayOf(const Tick& tick, const CutModel& piece) {
    return {.toolInTooth = tick.contact.proxy,
            .normal = tick.contact.normal,
            .speedRpm = tick.spindle.speedRpm,
            .water = tick.input.cutting ? tick.input.pedal : 0,
            .ground = piece.loss().ground()};
}

}  // namespace

Demonstration playDemonstration(const std::shared_ptr<CutModel>& piece, const Box3& box, const Instrument& instrument,
                                const HapticSettings& settings, const Quat& grip, double seconds,
                                const std::function<void(double)>& progress, const StepwiseSession::EventSink& sink,
                                const std::stop_token& stop) {
    const Vec3 middle = box.center();
    const double reach = 0.12 * box.sizes().x();
    constexpr double kHeadroom = 6.0;  // mm above the highest cusp, so that the cavity is visible under the waiting bur
    ScriptedOperator hand(Vec3(middle.x() - reach, middle.y(), box.max().z() + kHeadroom), grip,
                          script(middle, reach, seconds));
    StepwiseSession session(piece, {instrument, settings, Placement::AtOnce}, sink);
    ForcePipeline pipeline(hand.info().limits);
    SprayParticleSystem spray(instrument.cutting.envelope.maxRadius());
    const TickSound tickSound(settings.spindle, settings.materials, instrument.edge);

    CutEvents events(piece->tooth().materials());
    Demonstration result;
    const auto count = static_cast<std::size_t>(seconds / kTick);
    result.ticks.reserve(count);
    double time = 0;  // s, as in the ticks
    for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) {
        const DeviceSample sample = hand.read(kTick);
        if (hand.phaseIndex() < kTouchPhases) result.touchTick = i;
        const auto start = std::chrono::steady_clock::now();
        Tick tick = session.step({sample.hand, sample.pedal, hand.phase().cutting}, kTick, time);
        time += kTick;
        hand.write(pipeline.pass(forceCommandFrom(tick), kTick));
        tick.diagnostics.micros =
            std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
        result.ticks.push_back(tick);
        events.update(tick.time, tick, piece->loss());
        const bool isTurnToCut = i % kTicksPerCut == 0;
        const bool isChanged = isTurnToCut && session.carve();
        const bool isCut = isChanged && tick.contact.triangles > 0;  // else pieces have fallen
        session.list();
        if (isChanged) ++result.surfaceUpdates;
        if (!isTurnToCut) continue;
        spray.advance(sprayOf(tick, *piece), kTicksPerCut * kTick);
        if (isCut && tick.input.pedal > 0)
            result.work = {i, piece->surface(), {spray.particles().begin(), spray.particles().end()}};
        result.sound.push_back({tick.time, tickSound.at(tick), {}});
        progress(static_cast<double>(i) / static_cast<double>(count));
    }
    session.finish(/*dropsPieces=*/false);
    result.events = events.all();
    progress(1);
    return result;
}

}  // namespace tactooth

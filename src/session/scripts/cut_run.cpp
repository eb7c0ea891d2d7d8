// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/cut_run.h"

#include <algorithm>
#include <utility>

#include "session/io/finite_tick.h"
#include "session/scripts/touch_run.h"

namespace tactooth {
namespace {

constexpr double kSurfaceDelay = 0.005;  // s that the haptic surface may lag behind the cut

}  // namespace

SpindlePreset constantSpeed(double speedRpm) {
    SpindlePreset preset;
    preset.name = "constant speed";
    preset.freeSpeedRpm = preset.minSpeedRpm = std::max(speedRpm, 1.0);  // no drive has zero speed at full pedal
    preset.stallTorque = preset.brakeTorque = 1e6;                       // N*mm: nothing slows it
    preset.droopRpm = 1e-3;
    preset.inertia = 1e-9;
    preset.pedalCurve = PedalCurve::Electric;
    return preset;
}

BeginEvent cutSetup(Instrument instrument, HapticSettings settings) {
    settings.tickBudget = kUnlimitedWork;
    return {std::move(instrument), std::move(settings), Placement::AtOnce};
}

BeginEvent rigidCutSetup(Instrument instrument, const MaterialTable& materials, double speedRpm) {
    HapticSettings settings;
    settings.materials = materials;
    settings.spindle = constantSpeed(speedRpm);
    settings.spindle.freeSpeedRpm = speedRpm;
    return {std::move(instrument), std::move(settings), Placement::AtOnce};
}

Expected<void> cutKinematically(std::span<const TimedPose> path, bool spins, StepwiseSession& session,
                                const CutCallback& visit, const std::stop_token& stop) {
    double last = path.empty() ? 0 : path.front().time;
    for (const TimedPose& row : path) {
        if (stop.stop_requested()) break;
        double micros = 0;
        Tick tick = timed(micros, [&] { return session.sweep(row.toolInTooth, row.time - last, row.time, spins); });
        tick.diagnostics.micros = micros;
        last = row.time;
        if (auto finite = checkFinite(row.time, tick); !finite) return finite;
        visit(row.time, tick, session.model().loss());
    }
    session.finish(/*dropsPieces=*/false);
    return {};
}

void updateHapticSurface(const CutModel& piece, const Tick& tick, bool isCut, HapticSurfaceBuilder& surfaces,
                         HapticSimulation& simulation) {
    if (tick.contact.placed) surfaces.watch(tick.time, tick.contact.proxy, tick.diagnostics.ownListRebuilds);
    HapticSurface* hapticSurface =
        isCut ? surfaces.make(piece.contactSurface(), tick.contact.proxy, piece.reached().value_or(tick.contact.proxy))
              : surfaces.rebuild();
    if (hapticSurface == nullptr) return;
    simulation.setSurface(*hapticSurface);
    surfaces.recycle(hapticSurface);
}

Expected<void> cutWithRemovalLaw(std::span<const TimedPose> path, StepwiseSession& session, const CutCallback& visit,
                                 const std::stop_token& stop) {
    double last = path.empty() ? 0 : path.front().time;
    double lastCut = last;
    for (const TimedPose& row : path) {
        if (stop.stop_requested()) break;
        double micros = 0;
        Tick tick = timed(micros, [&] { return session.step({row.toolInTooth, 1, true}, row.time - last, row.time); });
        tick.diagnostics.micros = micros;
        last = row.time;
        if (auto finite = checkFinite(row.time, tick); !finite) return finite;
        const bool isTurnToCut = row.time - lastCut >= kSurfaceDelay - 1e-9;
        if (isTurnToCut) lastCut = row.time;
        if (isTurnToCut) (void)session.carve();
        session.list();
        visit(row.time, tick, session.model().loss());
    }
    session.finish(/*dropsPieces=*/true);
    return {};
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/cut_run.h"

#include <algorithm>
#include <numbers>

#include "session/io/finite_tick.h"
#include "session/scripts/touch_run.h"

namespace tactooth {
namespace {

constexpr double kSurfaceDelay = 0.005;  // s that the haptic surface may lag behind the cut

Tick rigidTick(const TimedPose& row, const Vec3& step, double dt) {
    Tick tick;
    tick.time = row.time;
    tick.hand = tick.proxy = row.toolInTooth;
    tick.placed = tick.cutting = true;
    tick.speed = dt > 0 ? step.norm() / dt : 0;
    return tick;
}

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

Expected<void> cutKinematically(std::span<const TimedPose> path, const CuttingTool& tool, double speedRpm,
                                const MaterialTable& materials, CutModel& piece, const CutCallback& visit) {
    const double rimSpeed = speedRpm / 60 * 2 * std::numbers::pi * tool.envelope.maxRadius() * 1e-3;  // m/s
    for (std::size_t i = 0; i < path.size(); ++i) {
        const TimedPose& before = path[i == 0 ? 0 : i - 1];
        const double dt = path[i].time - before.time;
        const Vec3 step = path[i].toolInTooth.position - before.toolInTooth.position;
        Tick tick = rigidTick(path[i], step, dt);
        if (speedRpm > 0) {
            const MaterialVolumes volumes =
                timed(tick.micros, [&] { return piece.sweep(tool, before.toolInTooth, path[i].toolInTooth); });
            const double travel = rimSpeed * dt;
            if (travel > 0 && step.norm() > 0) {
                tick.normal = -step.normalized();
                tick.wrench.force = workFor(volumes, materials, tool.sharpness) / travel * tick.normal;
            }
        }
        if (auto finite = checkFinite(path[i].time, tick); !finite) return finite;
        visit(path[i].time, tick, piece.loss());
    }
    piece.refreshSurface();
    return {};
}

void updateHapticSurface(const CutModel& piece, const Tick& tick, bool isCut, HapticSurfaceBuilder& surfaces,
                         HapticSimulation& simulation) {
    if (tick.placed) surfaces.watch(tick.time, tick.proxy, tick.ownListRebuilds);
    HapticSurface* hapticSurface =
        isCut ? surfaces.make(piece.contactSurface(), tick.proxy, piece.reached().value_or(tick.proxy))
              : surfaces.rebuild();
    if (hapticSurface == nullptr) return;
    simulation.setSurface(*hapticSurface);
    surfaces.recycle(hapticSurface);
}

Expected<void> cutWithRemovalLaw(std::span<const TimedPose> path, const CuttingTool& tool,
                                 const MaterialTable& materials, HapticSimulation& simulation, CutModel& piece,
                                 const CutCallback& visit) {
    simulation.setTickBudget(kUnlimitedWork);  // no real time here, and a bur that lags would cut more
    HapticSurfaceBuilder surfaces(simulation.tool(), piece.contactSurface());
    double last = path.empty() ? 0 : path.front().time;
    double lastCut = last;
    for (const TimedPose& row : path) {
        double micros = 0;
        Tick tick = timed(micros, [&] { return simulation.step({row.toolInTooth, 1, true}, row.time - last); });
        tick.micros = micros;
        last = row.time;
        if (auto finite = checkFinite(row.time, tick); !finite) return finite;
        const bool isTurnToCut = row.time - lastCut >= kSurfaceDelay - 1e-9;
        if (isTurnToCut) lastCut = row.time;
        const bool isCut = isTurnToCut && (piece.feed(tool, tick, materials) || piece.removeDetachedPieces(tick));
        updateHapticSurface(piece, tick, isCut, surfaces, simulation);
        visit(row.time, tick, piece.loss());
    }
    piece.removeDetachedPieces();
    return {};
}

}  // namespace tactooth

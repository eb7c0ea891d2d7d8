// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "session/scripts/trajectory.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// A drive with constant speed at any load, for runs along a given path.
[[nodiscard]] SpindlePreset constantSpeed(double speedRpm);

/// Called after each row of the path, with the loss of the tooth so far.
using CutCallback = std::function<void(double time, const Tick& tick, const ToothLoss& loss)>;

/// Cuts all that the bur sweeps along the path, at any force. The ticks hold the normal force that the removal law
/// would need, against the motion. Nothing resists, so the depth is 0 and the proxy is the device pose. Fails with one
/// sentence at the first tick that is not finite (see checkFinite).
[[nodiscard]] Expected<void> cutKinematically(std::span<const TimedPose> path, const CuttingTool& tool, double speedRpm,
                                              const MaterialTable& materials, CutModel& piece,
                                              const CutCallback& visit);

/// Gives the simulation the surface of the model after `tick`, with a neighbour list for the next ticks. Call it after
/// each tick. `isCut`: the model has changed in it.
void updateHapticSurface(const CutModel& piece, const Tick& tick, bool isCut, HapticSurfaceBuilder& surfaces,
                         HapticSimulation& simulation);

/// Follows the path with the device pose; the removal law limits the cut. The haptic surface lags behind the cut by at
/// most 5 ms of simulated time. Detached pieces fall when the bur is lifted and at the end of the path. Fails as
/// cutKinematically does.
[[nodiscard]] Expected<void> cutWithRemovalLaw(std::span<const TimedPose> path, const CuttingTool& tool,
                                               const MaterialTable& materials, HapticSimulation& simulation,
                                               CutModel& piece, const CutCallback& visit);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "session/scripts/trajectory.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// A drive that turns at one speed whatever the load, for runs along a given path.
[[nodiscard]] SpindlePreset constantSpeed(double speedRpm);

/// Called after every row of the path, with what the tooth has lost so far.
using CutCallback = std::function<void(double time, const Tick& tick, const ToothLoss& loss)>;

/// Cuts all that the bur sweeps along the path, whatever force it would take. That force is told (normal force that the
/// removal law asks for, against the motion); nothing is held back, so depth is 0 and the proxy is the hand. Fails with
/// one sentence at the first tick that is not finite (see checkFinite).
[[nodiscard]] Expected<void> cutKinematically(std::span<const TimedPose> path, const CuttingTool& tool, double speedRpm,
                                              const MaterialTable& materials, CutModel& piece,
                                              const CutCallback& visit);

/// Lets the hand feel the piece as it is after `tick`, with what is near the tool listed ahead for the ticks to come.
/// To be called after each tick. `isCut`: the piece has changed in it.
void updateHapticSurface(const CutModel& piece, const Tick& tick, bool isCut, HapticSurfaceBuilder& surfaces,
                         HapticSimulation& simulation);

/// Follows the path with the hand; the tooth gives way only as fast as the removal law lets it. The felt surface
/// follows the cut by no more than 5 ms of simulated time. Pieces that come loose fall when the bur is lifted, and at
/// the end of the path. Fails as cutKinematically does.
[[nodiscard]] Expected<void> cutWithRemovalLaw(std::span<const TimedPose> path, const CuttingTool& tool,
                                               const MaterialTable& materials, HapticSimulation& simulation,
                                               CutModel& piece, const CutCallback& visit);

}  // namespace tactooth

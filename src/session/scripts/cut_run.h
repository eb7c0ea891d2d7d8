// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <stop_token>

#include "session/kernel/stepwise_session.h"
#include "session/scripts/trajectory.h"

namespace tactooth {

/// A drive with constant speed at any load, for runs along a given path.
[[nodiscard]] SpindlePreset constantSpeed(double speedRpm);

/// Called after each row of the path, with the loss of the tooth so far.
using CutCallback = std::function<void(double time, const Tick& tick, const ToothLoss& loss)>;

/// The first event of a session for cutWithRemovalLaw. There is no real time, and a bur that lags would cut more, so
/// its ticks have no work budget.
[[nodiscard]] BeginEvent cutSetup(Instrument instrument, HapticSettings settings);

/// The first event of a session for cutKinematically; any speed, also a very low one.
[[nodiscard]] BeginEvent rigidCutSetup(Instrument instrument, const MaterialTable& materials, double speedRpm);

/// Cuts all that the bur sweeps along the path, at any force; nothing if it does not spin. The ticks hold the normal
/// force that the removal law would need, against the motion. Nothing resists, so the depth is 0 and the proxy is the
/// device pose. Fails with one sentence at the first tick that is not finite (see checkFinite). Ends early when `stop`
/// asks for it.
[[nodiscard]] Expected<void> cutKinematically(std::span<const TimedPose> path, bool spins, StepwiseSession& session,
                                              const CutCallback& visit, const std::stop_token& stop = {});

/// Gives the simulation the surface of the model after `tick`, with a neighbour list for the next ticks. Call it after
/// each tick. `isCut`: the model has changed in it.
void updateHapticSurface(const CutModel& piece, const Tick& tick, bool isCut, HapticSurfaceBuilder& surfaces,
                         HapticSimulation& simulation);

/// Follows the path with the device pose; the removal law limits the cut. The haptic surface lags behind the cut by at
/// most 5 ms of simulated time. Detached pieces fall when the bur is lifted and at the end of the path. Fails and ends
/// as cutKinematically does.
[[nodiscard]] Expected<void> cutWithRemovalLaw(std::span<const TimedPose> path, StepwiseSession& session,
                                               const CutCallback& visit, const std::stop_token& stop = {});

}  // namespace tactooth

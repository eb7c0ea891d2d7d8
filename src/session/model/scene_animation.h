// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "haptics/haptic_simulation.h"
#include "session/simulation/pulp_opening.h"
#include "session/simulation/work_liquids.h"

namespace tactooth {

/// What moves in the picture beside the tool: the bur turns, water and chips fly, liquids spread on the tooth.
class SceneAnimation {
public:
    /// Removes all particles: another tooth or bur has come. `burRadius`: of the bur's widest part, mm; `tube`: opening
    /// of the suction tube, tooth frame.
    void restart(double burRadius, const Vec3& tube) { spray_ = SprayParticleSystem(burRadius, tube); }
    /// Where the pulp bleeds; call it before `advance`. `tooth`: its surface now.
    void followPulp(const CutEvents& events, const Surface& tooth, const MaterialRegistry& materials) {
        pulp_.follow(events, tooth, materials);
    }
    /// `dt` s after the last call. `water`, `suction`: whether they are on; `ground`: off the tooth so far, mm^3.
    void advance(const Tick& tick, bool water, bool suction, const MaterialVolumes& ground, double dt);

    /// Angle of the bur about its axis, -pi to pi, rad.
    [[nodiscard]] double spin() const { return spin_; }
    [[nodiscard]] std::span<const SprayParticle> particles() const { return spray_.particles(); }
    [[nodiscard]] const WorkLiquids& liquids() const { return liquids_; }

private:
    double spin_ = 0;
    SprayParticleSystem spray_;
    PulpOpening pulp_;
    WorkLiquids liquids_;
};

}  // namespace tactooth

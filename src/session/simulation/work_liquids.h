// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "session/simulation/spray_particle_system.h"

namespace tactooth {

/// Liquids on the tooth, for pictures: the film of the spray with what was ground off in it, and blood from an opened
/// pulp. Equal calls give equal bits.
class WorkLiquids {
public:
    /// Advances by `dt` seconds. `opening`: of the pulp, tooth frame; none: it is closed.
    void advance(const SprayInput& now, const std::optional<Vec3>& opening, double dt);

    /// Where the spray last arrived, tooth frame.
    [[nodiscard]] const Vec3& spot() const { return spot_; }
    /// Of the film, 0..1.
    [[nodiscard]] double water() const { return water_; }
    /// How milky the film is, 0..1.
    [[nodiscard]] double slurry() const { return slurry_; }
    /// Of the pulp, tooth frame.
    [[nodiscard]] const Vec3& opening() const { return opening_; }
    /// How far blood has spread from the opening, mm.
    [[nodiscard]] double blood() const { return kBloodReach * blood_; }

    static constexpr double kWets = 0.15;       ///< s, until the film is 1 - 1/e of the flow
    static constexpr double kDries = 2.5;       ///< s, from a full film to none
    static constexpr double kMilky = 0.12;      ///< mm^3 ground off that make the film 1 - 1/e milky
    static constexpr double kRinses = 0.8;      ///< s, in which the spray takes slurry away to 1/e
    static constexpr double kBleeds = 1.6;      ///< s, until blood has 1 - 1/e of its reach
    static constexpr double kWashes = 0.3;      ///< s, in which the spray takes blood away to 1/e
    static constexpr double kBloodReach = 1.7;  ///< mm, the farthest: blood stays in the cavity

private:
    Vec3 spot_ = Vec3::Zero(), opening_ = Vec3::Zero();
    double water_ = 0, slurry_ = 0;
    double blood_ = 0;              // share of the reach
    std::optional<double> ground_;  // at the last call, mm^3
};

}  // namespace tactooth

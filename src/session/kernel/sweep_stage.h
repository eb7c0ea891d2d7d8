// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "geometry/util/fnv1a.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// The part of a session in which a rigid bur removes all that it sweeps, whatever force that takes. Equal calls give
/// equal ticks and teeth, bit for bit.
class SweepStage {
public:
    /// The model is not null. `speedRpm`: of the bur, at any load. `materials`: those of the tooth.
    SweepStage(std::shared_ptr<CutModel> model, const CuttingTool& tool, double speedRpm, MaterialTable materials);

    /// Moves the bur from its last pose to this one, at the first call in place. The tick holds the normal force that
    /// the removal law would need, against the motion. `time` and `elapsed`: s. `spins`: whether the bur turns; else it
    /// cuts nothing. The model's surface is not brought up to date.
    [[nodiscard]] Tick step(const Pose& tool, double time, double elapsed, bool spins);

    /// Hash of the results of all ticks so far.
    [[nodiscard]] std::uint64_t hash() const { return hash_.value(); }

private:
    std::shared_ptr<CutModel> model_;
    CuttingTool tool_;
    double rimSpeed_;  // m/s
    MaterialTable materials_;
    std::optional<Pose> last_;
    std::uint32_t ticks_ = 0;
    Fnv1a hash_;
};

}  // namespace tactooth

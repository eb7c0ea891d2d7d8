// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tooth/sweep/swept_envelope.h"
#include "tooth/volume/brick.h"
#include "tooth/volume/brick_key.h"
#include "tooth/volume/material_volumes.h"

namespace tactooth {

/// What a move of the bur would remove from one brick, and the new values of the cut field.
struct BrickRemoval {
    struct Sample {
        std::uint16_t node;  ///< nodeIndex
        float distance;      ///< new value of the cut field, mm
        OctahedralNormal normal;
        double gone = 0;  ///< share of the node's voxel that lies in the tooth and is removed already, 0..1
    };
    BrickKey key{};
    MaterialVolumes volumes{};
    std::vector<Sample> lowered;
};

/// A plan of a carve: what a move of the bur would remove, and the data to remove it.
struct PlannedRemoval {
    MaterialVolumes volumes{};
    std::vector<BrickRemoval> where;  ///< in ascending order of the keys
    std::vector<SweepStep> steps;
    double clearance = 0;          ///< clearance of the plan, mm
    std::uint64_t afterCarve = 0;  ///< number of the carve before; the plan is valid until the next one
};

}  // namespace tactooth

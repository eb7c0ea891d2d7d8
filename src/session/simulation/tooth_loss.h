// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "tooth/volume/material_volumes.h"

namespace tactooth {

/// The volume that a tooth has lost since it was whole.
struct ToothLoss {
    MaterialVolumes removed{};   ///< in all, mm^3
    MaterialVolumes detached{};  ///< of that, in pieces that burs had cut off all around, mm^3
    std::size_t pieces = 0;      ///< fallen pieces that an eye can see (kVisiblePiece)
    double beside = 0;           ///< of all, lost by bodies around the tooth, mm^3
    std::size_t nearPulp = 0;    ///< 1: a bur that cut has come within kAtPulp of the pulp; a word, as the rest

    /// The volume that burs have ground to chips.
    [[nodiscard]] MaterialVolumes ground() const {
        MaterialVolumes volumes = removed;
        for (std::size_t i = 0; i < kMaxMaterials; ++i) volumes[i] -= detached[i];
        return volumes;
    }
};

/// mm^3: a cube of 0.2 mm. A smaller detached piece is dust.
inline constexpr double kVisiblePiece = 0.008;

}  // namespace tactooth

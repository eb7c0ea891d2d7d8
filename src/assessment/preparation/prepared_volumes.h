// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "assessment/gauge/column_grid.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// What was removed and what should have been, mm^3.
struct PreparedVolumes {
    double common = 0;  ///< removed, and to be removed
    double over = 0;    ///< removed, but not to be removed
    double under = 0;   ///< to be removed, but not removed
    double beyond = 0;  ///< removed, and farther from the ideal surface than the tolerance; only where it is asked for
    /// The parts of one tissue; 0 where the tooth has no layers.
    struct Tissue {
        double removed = 0;
        double over = 0;   ///< of it what was not to be removed
        double under = 0;  ///< of `kept` what was to be removed
        double kept = 0;   ///< what is left of the tissue along the lines
    };
    std::array<Tissue, kMaterialRoleCount> tissues = {};  ///< by MaterialRole

    /// 0..1: 2 common / (removed + to be removed).
    [[nodiscard]] double dice() const;
    /// 0..1: the removed share of what was to be removed.
    [[nodiscard]] double clearedShare() const;
};

/// Sums lengths along the lines of `columns`, which cover both cut surfaces. Where less than kCavityDepth is removed
/// along a line, nothing counts as removed there. `hasBeyond`: PreparedVolumes::beyond, too, which takes a while.
[[nodiscard]] PreparedVolumes preparedVolumes(const Preparation& preparation, const ColumnGrid& columns,
                                              bool hasBeyond = false);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// How much of a body lies at each height.
struct SectionProfile {
    double bottom = 0;          ///< mm
    double step = 0;            ///< mm, between two sections
    std::vector<double> areas;  ///< mm^2, at bottom + (i + 0.5) * step
};

/// The sections of a closed surface across z. Any other direction is turned to z first.
[[nodiscard]] SectionProfile sectionProfile(const TriangleMesh& closed, int sections = 60);

/// Where the crown passes into the root of a tooth that stands crown up, mm: the height below the widest section at
/// which the section has shrunk most of its way to the root's, within what crowns have of a tooth's length; the bottom
/// for a crown without a root.
[[nodiscard]] double neckHeight(const SectionProfile& profile);

}  // namespace tactooth

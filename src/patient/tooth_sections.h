// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Areas of the sections of a body at each height.
struct SectionProfile {
    double bottom = 0;          ///< mm
    double step = 0;            ///< mm, between two sections
    std::vector<double> areas;  ///< mm^2, at bottom + (i + 0.5) * step
};

/// The sections of a closed surface perpendicular to z. Rotate any other direction to z first.
[[nodiscard]] SectionProfile sectionProfile(const TriangleMesh& closed, int sections = 60);

/// Height of the neck of a tooth with its crown up, mm: the height below the widest section at which the section has
/// shrunk most of its way to that of the root, within the range of crown lengths; the bottom for a crown without a
/// root.
[[nodiscard]] double neckHeight(const SectionProfile& profile);

}  // namespace tactooth

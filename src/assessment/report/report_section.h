// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/preparation/preparation.h"
#include "geometry/mesh/plane_section.h"
#include "geometry/util/message.h"

namespace tactooth {

/// A section through a preparation, for a drawing.
struct ReportSection {
    std::string title;        ///< "Mesiodistal section"
    std::string left, right;  ///< what lies on the two sides: "mesial"
    Eigen::AlignedBox2d box;  ///< what is drawn, mm
    std::vector<SectionLine> uncut = {}, prepared = {}, ideal = {}, pulp = {};  ///< mm
};

/// Two sections along the axis of the preparation and square to each other. `worst`: the place of the deepest
/// over-preparation, mm, if there is one: a section that shows its depth goes through it, the other one through the
/// middle of the preparation.
[[nodiscard]] std::vector<ReportSection> reportSections(const Preparation& preparation, const CutSurfaces& surfaces,
                                                        const std::optional<Vec3>& worst,
                                                        Language language = Language::English);

/// A drawing (SVG) of this width, mm.
[[nodiscard]] std::string sectionSvg(const ReportSection& section, double width, Language language = Language::English);
/// Its height, mm.
[[nodiscard]] double sectionHeight(const ReportSection& section, double width);

}  // namespace tactooth

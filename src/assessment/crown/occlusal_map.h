// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "assessment/crown/finish_line.h"
#include "assessment/crown/removed_body.h"

namespace tactooth {

/// The occlusal surface of a stump: that of the uncut tooth, evened out so that its slopes are planes, and lowered
/// square to itself; deeper on the side of the functional cusps.
class OcclusalMap {
public:
    /// `line`: of the preparation, for its axis; `outer`: the uncut tooth.
    OcclusalMap(const CrownOutline& crown, const FinishLine& line, std::shared_ptr<const SurfacePart> outer);

    /// How deep a place lies in what is removed over that surface.
    [[nodiscard]] RemovedBody::Depth over(const Vec3& place) const;

private:
    [[nodiscard]] double& at(std::vector<double>& grid, int i, int j) const;
    [[nodiscard]] double at(const std::vector<double>& grid, int i, int j) const;
    [[nodiscard]] double slopeAt(const std::vector<double>& grid, int i, int j) const;
    [[nodiscard]] std::vector<double> smoothed(const std::vector<double>& grid, double width) const;
    void lower(const CrownOutline& crown, const std::vector<double>& uncut, double middle);

    Vec3 axis_, u_, v_;
    Vec2 corner_ = Vec2::Zero();
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;  // of the stump along the axis, mm
};

}  // namespace tactooth

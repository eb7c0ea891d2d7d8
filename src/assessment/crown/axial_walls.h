// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/crown/finish_line.h"
#include "assessment/crown/removed_body.h"

namespace tactooth {

/// The floor of the finish line and the walls above it, once round a stump. The buccal wall may lean less or more than
/// the others, with a smooth change at the line angles.
class AxialWalls {
public:
    AxialWalls(const CrownOutline& crown, const FinishLine& line);

    /// How deep a place lies outside the walls. `at`: the same place as seen from the finish line.
    [[nodiscard]] RemovedBody::Depth outside(const Vec3& place, const FinishLine::Place& at) const;

private:
    struct Taper {
        double angle;   // rad
        Vec3 gradient;  // rad/mm
    };
    [[nodiscard]] Taper taperAt(const Vec3& place) const;

    double width_, tipRadius_;    // mm
    double taper_, buccalTaper_;  // rad
    Vec3 axis_, aside_, middle_;
};

}  // namespace tactooth

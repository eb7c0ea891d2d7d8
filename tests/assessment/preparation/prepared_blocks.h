// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "assessment/preparation/preparation_metrics.h"

namespace tactooth::test {

/// A rectangle from (left, back) to (right, front); the height of each of its sides x = left and x = right, mm.
struct Rectangle {
    double left, right, back, front;
    double leftHeight, rightHeight;

    static Rectangle level(double left, double right, double back, double front, double height) {
        return {left, right, back, front, height, height};
    }
};

/// The block from (-5, -5, -5) to (5, 5, `top`) with a rectangle `opening` in its top, from which four walls lead to
/// the rectangle `end`: below it the floor of a cavity, above it the end of a stump.
[[nodiscard]] TriangleMesh preparedBlock(double top, const Rectangle& opening, const Rectangle& end);

/// The same with a cavity in the whole block, whose top is at z = 5.
[[nodiscard]] inline TriangleMesh blockWithCavityTo(const Rectangle& opening, const Rectangle& floor) {
    return preparedBlock(5, opening, floor);
}

/// An upright box of this opening as cavity, down to z = `floor`.
[[nodiscard]] TriangleMesh blockWithBox(double left, double right, double back, double front, double floor);

/// A cavity with upright walls from y = -1.5 to 1.5 mm, whose floor has a profile: places (x, z) of rising x.
[[nodiscard]] TriangleMesh blockWithFloorProfile(const std::vector<Vec2>& profile);

/// A cavity of Class II, seen from above, 2 mm deep: a slot from x = -3 to 1 mm, 1.2 mm wide, and a box from there to
/// x = 2.4 mm, 2.8 mm wide.
[[nodiscard]] TriangleMesh blockWithSlotAndBox();

/// A cavity down to z = `floor` with upright walls, whose outline is a circle around the z axis with `waves` waves of
/// `amplitude`, mm.
[[nodiscard]] TriangleMesh blockWithRoundCavity(double radius, double amplitude, int waves, double floor);

/// A round cavity with upright walls, down to z = `floor`, whose angle between floor and wall has this radius, mm.
[[nodiscard]] TriangleMesh blockWithRoundedAngle(double radius, double angle, double floor);

/// A student's work on the whole block against an ideal one.
[[nodiscard]] Preparation blockPreparation(TriangleMesh prepared, TriangleMesh ideal);

/// The value of one metric; a failed test where it cannot be measured.
[[nodiscard]] double valueOf(const PreparationMeasures& measures, std::string_view id);
/// The reason why a metric has no value; a failed test where it has one.
[[nodiscard]] std::string_view reasonOf(const PreparationMeasures& measures, std::string_view id);

}  // namespace tactooth::test

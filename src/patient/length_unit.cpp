// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/length_unit.h"

#include <algorithm>

#include "geometry/util/assert.h"
#include "patient/messages.h"

namespace tactooth {
namespace {

// Whole permanent teeth are 19 to 27 mm long on average (Wheeler); variation, children and a missing root tip widen
// this range. Crowns are 7 to 11 mm high and as wide.
struct Range {
    double low, high;  // mm
    [[nodiscard]] bool holds(double length) const { return low <= length && length <= high; }
};
constexpr Range kToothLength = {12, 34};
constexpr Range kCrownLength = {5, 12};
constexpr double kAverageTooth = 21;  // mm: mean length of Wheeler's 32 teeth

}  // namespace

std::optional<LengthUnit> lengthUnitFromName(std::string_view name) {
    const auto found = std::ranges::find(kLengthUnits, name, [](const LengthUnit& unit) { return unit.name; });
    if (found == kLengthUnits.end()) return std::nullopt;
    return *found;
}

ScaleGuess guessScale(double longest) {
    TACTOOTH_ASSERT(longest > 0);
    if (kCrownLength.holds(longest))
        return {1, {ImportNoteTopic::Units, {msg::kNoteUnitOfCrown, "mm", rounded(longest, 1)}}};
    for (const auto& [range, text] :
         {std::pair(kToothLength, &msg::kNoteUnitOfTooth), std::pair(kCrownLength, &msg::kNoteUnitOfCrown)}) {
        for (const LengthUnit& unit : kLengthUnits) {
            if (!range.holds(longest * unit.mm)) continue;
            return {unit.mm, {ImportNoteTopic::Units, {*text, unit.name, rounded(longest * unit.mm, 1)}}};
        }
    }
    const double scale = kAverageTooth / longest;
    return {scale,
            {ImportNoteTopic::Units,
             {msg::kNoteNoUnit, rounded(longest, 2), rounded(scale, 5), rounded(kAverageTooth, 0)}}};
}

void scaleToMm(TriangleMesh& mesh, double mmPerUnit) {
    if (mmPerUnit == 1) return;
    for (Vec3f& vertex : mesh.vertices) vertex = (mmPerUnit * vertex.cast<double>()).cast<float>();
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "geometry/io/import_note.h"
#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

struct LengthUnit {
    const char* name;
    double mm;
};

/// Possible units of surfaces; STL files do not contain one. Millimetres first.
inline constexpr std::array<LengthUnit, 5> kLengthUnits = {
    {{"mm", 1}, {"cm", 10}, {"inch", 25.4}, {"m", 1000}, {"um", 0.001}}};

[[nodiscard]] std::optional<LengthUnit> lengthUnitFromName(std::string_view name);

/// Length of one unit of a file.
struct ScaleGuess {
    double mmPerUnit = 1;
    ImportNote why;
};

/// Guesses the unit from the longest side of a tooth's box: the first of mm, cm, inch, m and um in which it is as long
/// as a tooth or a crown, a whole tooth before a crown. Where none fits, the surface has no unit of length and is
/// scaled to the length of an average tooth. `longest`: of the box, in the file's unit, above 0.
[[nodiscard]] ScaleGuess guessScale(double longest);

/// Converts a mesh from a file's unit to mm.
void scaleToMm(TriangleMesh& mesh, double mmPerUnit);

}  // namespace tactooth

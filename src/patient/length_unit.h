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

/// The units that surfaces come in; STL files do not say which. Millimetres first.
inline constexpr std::array<LengthUnit, 5> kLengthUnits = {
    {{"mm", 1}, {"cm", 10}, {"inch", 25.4}, {"m", 1000}, {"um", 0.001}}};

[[nodiscard]] std::optional<LengthUnit> lengthUnitFromName(std::string_view name);

/// How large one unit of a file is.
struct ScaleGuess {
    double mmPerUnit = 1;
    ImportNote why;
};

/// The longest side of a tooth's box tells its unit: the first of mm, cm, inch, m and um in which it is as long as a
/// tooth or a crown may be, a whole tooth before a crown. Where none fits, the surface has no unit of length and is
/// scaled to the length of an average tooth. `longest`: of the box, in the file's unit, above 0.
[[nodiscard]] ScaleGuess guessScale(double longest);

/// A mesh in a file's unit becomes one in mm.
void scaleToMm(TriangleMesh& mesh, double mmPerUnit);

}  // namespace tactooth

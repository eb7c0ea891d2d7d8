// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// An explorer No. 23, the shepherd's hook, as a closed surface: origin at the tip, which points toward -x, the handle
/// along +z; mm.
[[nodiscard]] TriangleMesh makeExplorer();

/// A probe's marks, mm from the tip (Williams).
inline constexpr std::array<double, 8> kProbeMarks = {1, 2, 3, 5, 7, 8, 9, 10};

/// A periodontal probe with a ring at each mark, as a closed surface: origin at the blunt tip (0.5 mm), the marked end
/// along +z, the handle leaving toward +x; mm.
[[nodiscard]] TriangleMesh makePeriodontalProbe();

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "patient/scan_import.h"

namespace tactooth {

/// What several teeth of one jaw tell about each other.
struct JawFrame {
    double mmPerUnit = 1;
    std::vector<ImportNote> why;         ///< of a unit that was guessed
    std::vector<Vec3> buccalDirections;  ///< of each tooth: toward its cheek, about; empty if their arch does not tell
};

/// Teeth of one jaw come in one unit, that of the middle one by size (if `mmPerUnit` does not tell it), and their
/// cheeks look away from the middle of their arch. Fails with one sentence if a scan is empty.
[[nodiscard]] Expected<JawFrame> findJawFrame(std::span<const Scan> teeth, std::optional<double> mmPerUnit);

}  // namespace tactooth

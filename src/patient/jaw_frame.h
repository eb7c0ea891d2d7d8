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

/// What several teeth of one jaw say about each other.
struct JawFrame {
    double mmPerUnit = 1;
    std::vector<ImportNote> why;  ///< reasons for a guessed unit
    std::vector<Vec3>
        buccalDirections;  ///< of each tooth: approximate direction to its cheek; empty if the arch does not show it
};

/// Teeth of one jaw have one unit, that of the median tooth by size (unless `mmPerUnit` gives it), and their buccal
/// sides face away from the centre of the arch. Fails with one sentence if a scan is empty.
[[nodiscard]] Expected<JawFrame> findJawFrame(std::span<const Scan> teeth, std::optional<double> mmPerUnit);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/cli/cases/assess_command.h"
#include "app/common/report/make_report.h"
#include "geometry/io/import_note.h"

namespace tactooth {

/// What is assessed, in one frame.
struct AssessInput {
    AssessedWork work;
    std::vector<ImportNote> importNotes = {};
};

/// Reads and places all that the options name. Fails with one sentence.
[[nodiscard]] Expected<AssessInput> loadAssessInput(const AssessOptions& options);

}  // namespace tactooth

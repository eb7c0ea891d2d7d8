// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/cases/assess_command.h"
#include "app/cli/cases/assess_source.h"

namespace tactooth {

/// Assesses each work in the folder `options.student`: a report for each in a folder of its own, a page for each
/// student whose trials have a folder, and a table of all. A work that cannot be assessed has a row that says why.
/// Returns kExitOk if all pass, kExitNegative if one fails, and kExitBadInput if one cannot be assessed.
[[nodiscard]] int runAssessClass(const AssessOptions& options, const AssessSource& source);

}  // namespace tactooth

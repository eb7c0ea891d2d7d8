// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "assessment/report/stored_report.h"

namespace tactooth {

/// The files report.json in a folder and in the folders inside it, in the order of their paths. Fails with one sentence
/// if a folder cannot be read.
[[nodiscard]] Expected<std::vector<std::filesystem::path>> reportFilesIn(const std::filesystem::path& folder);

/// Those reports, in the order of time; `except`: a file that is left out. Fails with one sentence if one of them
/// cannot be read.
[[nodiscard]] Expected<std::vector<StoredReport>> storedReportsIn(const std::filesystem::path& folder,
                                                                  const std::filesystem::path& except = {});

/// Those of `reports` that can be compared with `present`, are not of its own work, and are not of a later one. Says to
/// stderr which others there are.
[[nodiscard]] std::vector<StoredReport> earlierTrials(std::vector<StoredReport> reports, const StoredReport& present);

}  // namespace tactooth

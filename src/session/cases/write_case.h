// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/util/expected.h"
#include "session/cases/case_store.h"

namespace tactooth {

/// Whether writeCase may write there, before the work of making a case is done: fails with its sentence where a folder
/// holds something already.
[[nodiscard]] Expected<void> checkCaseTarget(const std::filesystem::path& to);

/// Writes an archive if the name ends in .ttcase, else a folder, which must be new or empty. After a failure there is
/// neither, and an empty folder is as it was.
[[nodiscard]] Expected<void> writeCase(const std::vector<CaseFile>& files, const std::filesystem::path& to);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "geometry/util/expected.h"
#include "session/cases/case_store.h"

namespace tactooth {

/// Checks, before the case is made, that writeCase can write there. Fails with the sentence of writeCase if a folder is
/// not empty.
[[nodiscard]] Expected<void> checkCaseTarget(const std::filesystem::path& to);

/// Writes an archive if the name ends in .ttcase, else a folder, which must be new or empty. After a failure
/// neither exists, and an empty folder is unchanged.
[[nodiscard]] Expected<void> writeCase(const std::vector<CaseFile>& files, const std::filesystem::path& to);

}  // namespace tactooth

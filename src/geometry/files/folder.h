// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"

namespace tactooth {

/// Makes a folder and its missing parents. Fails with one sentence.
[[nodiscard]] Expected<void> makeFolder(const std::filesystem::path& folder);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "geometry/util/expected.h"

namespace tactooth {

/// One sentence on a file that cannot be written. `reason`: an errno.
[[nodiscard]] Unexpected cannotWrite(const std::filesystem::path& path, int reason);

}  // namespace tactooth

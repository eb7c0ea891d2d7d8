// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/folder.h"

#include <system_error>

#include "geometry/files/file_bytes.h"

namespace tactooth {

Expected<void> makeFolder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (!failure) return {};
    return unexpected("the folder " + displayName(folder) + " cannot be made (" + failure.message() +
                      "); give one that you may write to.");
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/folder.h"

#include <system_error>

#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {

Expected<void> makeFolder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (!failure) return {};
    return unexpected(msg::kOutputFolderNotMade, displayName(folder), systemReason(failure));
}

}  // namespace tactooth

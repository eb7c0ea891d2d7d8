// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/write_refusal.h"

#include <cerrno>

#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {

Unexpected cannotWrite(const std::filesystem::path& path, int reason) {
    const std::string name = displayName(path);
    if (reason == ENOENT || reason == ENOTDIR) return unexpected(msg::kOutputFolderMissing, name);
    if (reason == EACCES || reason == EPERM || reason == EROFS) {
        return unexpected(msg::kOutputFolderNotWritable, name);
    }
    return unexpected(msg::kOutputNotWritten, name, systemReason(reason));
}

}  // namespace tactooth

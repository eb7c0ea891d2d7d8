// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/staging_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "geometry/files/rename_together.h"
#include "geometry/files/temporary_file.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxTries = 100;       // against another program that removes stale files at that moment
constexpr mode_t kUsualMode = 0777;  // less the user's umask

Unexpected failed(int reason) { return unexpected(systemReason(reason)); }

}  // namespace

Expected<StagingFolder> StagingFolder::make(const fs::path& parent) {
    const auto namesLock = lockRenames();
    for (int i = 0; i < kMaxTries; ++i) {
        fs::path path = randomNameIn(parent);
        if (::mkdir(path.c_str(), kUsualMode) != 0) return failed(errno);
        const int lock = lockFolder(path);
        std::error_code ignored;
        if (fs::exists(path, ignored)) {
            registerUnfinished(path, Unfinished::Folder);
            return StagingFolder(std::move(path), lock);
        }
        if (lock >= 0) ::close(lock);
    }
    return failed(EEXIST);
}

StagingFolder::StagingFolder(StagingFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}

StagingFolder::~StagingFolder() {
    if (!path_.empty()) {
        const auto namesLock = lockRenames();
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        unregisterUnfinished(path_);
    }
    if (lock_ >= 0) ::close(lock_);
}

Expected<void> StagingFolder::renameTo(const fs::path& to) {
    syncFolder(path_);
    const auto namesLock = lockRenames();
    if (::rename(path_.c_str(), to.c_str()) != 0) return failed(errno);
    unregisterUnfinished(path_);
    path_.clear();
    syncFolder(to.parent_path());
    return {};
}

Expected<void> StagingFolder::moveUp() {
    const auto namesLock = lockRenames();
    const fs::path parent = path_.parent_path();
    std::vector<PendingRename> renames;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_, error)) {
        PendingRename& naming = renames.emplace_back();
        naming.from = entry.path().string();
        naming.to = (parent / entry.path().filename()).string();
    }
    if (error) return failed(error.value());
    if (const int reason = renameTogether(renames).reason; reason != 0) return failed(reason);
    syncFolder(parent);
    return {};
}

}  // namespace tactooth

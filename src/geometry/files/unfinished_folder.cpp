// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/unfinished_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "geometry/files/name_together.h"
#include "geometry/files/temporary_file.h"
#include "geometry/files/unfinished_names.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTries = 100;      // against who clears up just then
constexpr mode_t kUsualMode = 0777;  // less what the user's umask takes away

Unexpected failed(int reason) { return unexpected(std::generic_category().message(reason)); }

}  // namespace

Expected<UnfinishedFolder> UnfinishedFolder::make(const fs::path& parent) {
    const auto namesLock = whileNamesChange();
    for (int i = 0; i < kMostTries; ++i) {
        fs::path path = randomNameIn(parent);
        if (::mkdir(path.c_str(), kUsualMode) != 0) return failed(errno);
        const int lock = lockFolder(path);
        std::error_code ignored;
        if (fs::exists(path, ignored)) {
            noteUnfinished(path, Unfinished::Folder);
            return UnfinishedFolder(std::move(path), lock);
        }
        if (lock >= 0) ::close(lock);
    }
    return failed(EEXIST);
}

UnfinishedFolder::UnfinishedFolder(UnfinishedFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}

UnfinishedFolder::~UnfinishedFolder() {
    if (!path_.empty()) {
        const auto namesLock = whileNamesChange();
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        forgetUnfinished(path_);
    }
    if (lock_ >= 0) ::close(lock_);
}

Expected<void> UnfinishedFolder::becomes(const fs::path& to) {
    syncFolder(path_);
    const auto namesLock = whileNamesChange();
    if (::rename(path_.c_str(), to.c_str()) != 0) return failed(errno);
    forgetUnfinished(path_);
    path_.clear();
    syncFolder(to.parent_path());
    return {};
}

Expected<void> UnfinishedFolder::moveUp() {
    const auto namesLock = whileNamesChange();
    const fs::path parent = path_.parent_path();
    std::vector<Naming> namings;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_, error)) {
        Naming& naming = namings.emplace_back();
        naming.from = entry.path().string();
        naming.to = (parent / entry.path().filename()).string();
    }
    if (error) return failed(error.value());
    if (const int reason = nameTogether(namings).reason; reason != 0) return failed(reason);
    syncFolder(parent);
    return {};
}

}  // namespace tactooth

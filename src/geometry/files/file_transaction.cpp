// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_transaction.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>

#include "geometry/files/file_bytes.h"
#include "geometry/files/file_identity.h"
#include "geometry/files/folder.h"
#include "geometry/files/pending_file.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/util/assert.h"
#include "geometry/util/messages.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

std::atomic<FileTransaction*> theSet{nullptr};

/// Second names of the files that are replaced, locked so that no other program removes them as stale.
class Backups {
public:
    Backups() = default;
    Backups(const Backups&) = delete;
    Backups& operator=(const Backups&) = delete;
    ~Backups() {
        for (const int descriptor : locks_) ::close(descriptor);
    }

    void add(PendingRename& naming) {
        if (!naming.replaces) return;
        const std::string name = randomNameIn(fs::path(naming.to).parent_path()).string();
        const int descriptor = ::open(naming.to.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        if (descriptor >= 0) {
            (void)::flock(descriptor, LOCK_SH | LOCK_NB);
            locks_.push_back(descriptor);
        }
        if (::link(naming.to.c_str(), name.c_str()) == 0) naming.backup = name;
    }

private:
    std::vector<int> locks_;
};

}  // namespace

FileTransaction::FileTransaction() {
    TACTOOTH_ASSERT(theSet == nullptr);
    theSet = this;
}

FileTransaction::~FileTransaction() {
    theSet = nullptr;
    opened_.clear();
    finished_.clear();
    removeFolders();
}

FileTransaction* FileTransaction::current() { return theSet; }

void FileTransaction::reads(const fs::path& path) {
    if (!path.empty()) read_.push_back({FileIdentity::of(path), path});
}

Expected<void> FileTransaction::makeFolder(const fs::path& folder) {
    const auto lock = lockRenames();
    std::error_code ignored;
    std::vector<fs::path> missing;
    for (fs::path above = fs::absolute(folder, ignored); !fs::exists(above, ignored); above = above.parent_path()) {
        if (!above.has_filename()) continue;  // "folder/"
        missing.push_back(above);
    }
    auto made = tactooth::makeFolder(folder);
    for (auto each = missing.rbegin(); each != missing.rend(); ++each) {
        if (!fs::is_directory(*each, ignored)) break;
        registerUnfinished(*each, Unfinished::EmptyFolder);
        folders_.push_back(*each);
    }
    return made;
}

void FileTransaction::removeFolders() {
    const auto lock = lockRenames();
    for (; !folders_.empty(); folders_.pop_back()) {
        ::rmdir(folders_.back().c_str());
        unregisterUnfinished(folders_.back());
    }
}

Expected<void> FileTransaction::checkFree(const fs::path& path) const {
    const FileIdentity place = FileIdentity::of(path);
    for (const Known& input : read_) {
        const bool isPartOfIt = place.number != 0 && place.isInside(input.place);
        if (!isPartOfIt && place != input.place) continue;
        return unexpected(msg::kOutputIsInput, displayName(path), displayName(input.name));
    }
    for (const Known& other : written_) {
        if (place != other.place) continue;
        return unexpected(msg::kOutputNamedTwice, displayName(path), displayName(other.name));
    }
    return {};
}

Expected<void> FileTransaction::open(const fs::path& path) {
    if (path.empty()) return {};
    if (auto free = checkFree(path); !free) return free;
    auto file = PendingFile::open(path);
    if (!file) return Unexpected{file.error()};
    written_.push_back({FileIdentity::of(path), path});
    const std::lock_guard lock(mutex_);
    opened_.push_back(std::move(*file));
    return {};
}

std::unique_ptr<PendingFile> FileTransaction::handOut(const fs::path& path) {
    const FileIdentity place = FileIdentity::of(path);
    const std::lock_guard lock(mutex_);
    const auto found =
        std::ranges::find_if(opened_, [&](const auto& file) { return FileIdentity::of(file->path()) == place; });
    if (found == opened_.end()) return nullptr;
    std::unique_ptr<PendingFile> file = std::move(*found);
    opened_.erase(found);
    return file;
}

void FileTransaction::takeFinished(std::unique_ptr<PendingFile> file) {
    TACTOOTH_ASSERT(file != nullptr);
    const std::lock_guard lock(mutex_);
    finished_.push_back(std::move(file));
}

Expected<void> FileTransaction::commit() {
    const auto lock = lockRenames();
    Backups backups;
    std::vector<PendingRename> renames;
    for (const auto& file : finished_) renames.push_back(file->naming());
    if (renames.size() > 1) {
        for (PendingRename& naming : renames) backups.add(naming);
    }
    const RenameFailure failure = renameTogether(renames);
    TACTOOTH_ASSERT(failure.reason == 0 || failure.which < finished_.size());
    if (failure.reason != 0) return finished_[failure.which]->cannotBeNamed(failure.reason);
    for (const auto& file : finished_) file->close();
    finished_.clear();
    for (const fs::path& folder : folders_) unregisterUnfinished(folder);
    folders_.clear();
    return {};
}

}  // namespace tactooth

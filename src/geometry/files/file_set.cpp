// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_set.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cassert>

#include "geometry/files/file_bytes.h"
#include "geometry/files/file_place.h"
#include "geometry/files/folder.h"
#include "geometry/files/pending_file.h"
#include "geometry/files/unfinished_names.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

std::atomic<FileSet*> theSet{nullptr};

/// Second names of the files that are replaced, locked so that nobody takes them for left behind.
class Backups {
public:
    Backups() = default;
    Backups(const Backups&) = delete;
    Backups& operator=(const Backups&) = delete;
    ~Backups() {
        for (const int descriptor : locks_) ::close(descriptor);
    }

    void add(Naming& naming) {
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

FileSet::FileSet() {
    assert(theSet == nullptr);
    theSet = this;
}

FileSet::~FileSet() {
    theSet = nullptr;
    opened_.clear();
    finished_.clear();
    removeFolders();
}

FileSet* FileSet::current() { return theSet; }

void FileSet::reads(const fs::path& path) {
    if (!path.empty()) read_.push_back({FilePlace::of(path), path});
}

Expected<void> FileSet::makeFolder(const fs::path& folder) {
    const auto lock = whileNamesChange();
    std::error_code ignored;
    std::vector<fs::path> missing;
    for (fs::path above = fs::absolute(folder, ignored); !fs::exists(above, ignored); above = above.parent_path()) {
        if (!above.has_filename()) continue;  // "folder/"
        missing.push_back(above);
    }
    auto made = tactooth::makeFolder(folder);
    for (auto each = missing.rbegin(); each != missing.rend(); ++each) {
        if (!fs::is_directory(*each, ignored)) break;
        noteUnfinished(*each, Unfinished::EmptyFolder);
        folders_.push_back(*each);
    }
    return made;
}

void FileSet::removeFolders() {
    const auto lock = whileNamesChange();
    for (; !folders_.empty(); folders_.pop_back()) {
        ::rmdir(folders_.back().c_str());
        forgetUnfinished(folders_.back());
    }
}

Expected<void> FileSet::checkFree(const fs::path& path) const {
    const FilePlace place = FilePlace::of(path);
    for (const Known& input : read_) {
        const bool isPartOfIt = place.number != 0 && place.isInside(input.place);
        if (!isPartOfIt && place != input.place) continue;
        return unexpected(shownName(path) + ": cannot be written: this command reads it (as " + shownName(input.name) +
                          "); choose another name.");
    }
    for (const Known& other : written_) {
        if (place != other.place) continue;
        return unexpected(shownName(path) + ": cannot be written: it is the same file as " + shownName(other.name) +
                          ", which this command writes as well; choose another name.");
    }
    return {};
}

Expected<void> FileSet::open(const fs::path& path) {
    if (path.empty()) return {};
    if (auto free = checkFree(path); !free) return free;
    auto file = PendingFile::open(path);
    if (!file) return Unexpected{file.error()};
    written_.push_back({FilePlace::of(path), path});
    const std::lock_guard lock(mutex_);
    opened_.push_back(std::move(*file));
    return {};
}

std::unique_ptr<PendingFile> FileSet::handOut(const fs::path& path) {
    const FilePlace place = FilePlace::of(path);
    const std::lock_guard lock(mutex_);
    const auto found =
        std::ranges::find_if(opened_, [&](const auto& file) { return FilePlace::of(file->path()) == place; });
    if (found == opened_.end()) return nullptr;
    std::unique_ptr<PendingFile> file = std::move(*found);
    opened_.erase(found);
    return file;
}

void FileSet::takeFinished(std::unique_ptr<PendingFile> file) {
    const std::lock_guard lock(mutex_);
    finished_.push_back(std::move(file));
}

Expected<void> FileSet::commit() {
    const auto lock = whileNamesChange();
    Backups backups;
    std::vector<Naming> namings;
    for (const auto& file : finished_) namings.push_back(file->naming());
    if (namings.size() > 1) {
        for (Naming& naming : namings) backups.add(naming);
    }
    const NamingFailure failure = nameTogether(namings);
    if (failure.reason != 0) return finished_[failure.which]->cannotBeNamed(failure.reason);
    for (const auto& file : finished_) file->close();
    finished_.clear();
    for (const fs::path& folder : folders_) forgetUnfinished(folder);
    folders_.clear();
    return {};
}

}  // namespace tactooth

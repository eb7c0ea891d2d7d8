// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/file/journal_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/files/temporary_file.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/files/write_refusal.h"
#include "geometry/util/assert.h"
#include "journal/file/messages.h"
#include "journal/format/file_header.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

class DiskFile final : public JournalFile {
public:
    DiskFile(fs::path path, TemporaryFile file, bool replaces)
        : path_(std::move(path)), file_(std::move(file)), replaces_(replaces) {}
    ~DiskFile() override {
        removeRandomName();
        ::close(file_.descriptor);
    }

    Written write(std::span<const std::byte> bytes) override {
        const ssize_t count = ::write(file_.descriptor, bytes.data(), bytes.size());
        if (count < 0) return {0, errno};
        return {static_cast<std::size_t>(count), 0};
    }

    int sync() override {
        if (::fdatasync(file_.descriptor) != 0 && errno != EINVAL) return errno;  // EINVAL: nothing to bring there
        struct stat status {};
        if (::fstat(file_.descriptor, &status) != 0) return errno;
        return isPublished_ && status.st_nlink == 0 ? ENOENT : 0;
    }

    int publish() override {
        TACTOOTH_ASSERT(!isPublished_);
        const auto lock = lockRenames();
        if (const int failure = replaces_ ? takeName() : linkName(); failure != 0) return failure;
        isPublished_ = true;
        if (!file_.name.empty()) forgetRandomName();
        syncFolder(path_.parent_path());
        return 0;
    }

private:
    /// The name must be free.
    [[nodiscard]] int linkName() const {
        if (file_.name.empty()) return linkUnnamed(file_.descriptor, path_.c_str());
        return ::link(file_.name.c_str(), path_.c_str()) == 0 ? 0 : errno;
    }
    /// Replaces what has the name.
    [[nodiscard]] int takeName() {
        fs::path from = file_.name;
        if (from.empty()) {
            from = randomNameIn(path_.parent_path());
            if (const int failure = linkUnnamed(file_.descriptor, from.c_str()); failure != 0) return failure;
        }
        const int failure = ::rename(from.c_str(), path_.c_str()) == 0 ? 0 : errno;
        if (failure != 0 && file_.name.empty()) ::unlink(from.c_str());
        return failure;
    }

    void removeRandomName() {
        if (file_.name.empty()) return;
        const auto lock = lockRenames();
        forgetRandomName();
    }
    void forgetRandomName() {
        ::unlink(file_.name.c_str());
        unregisterUnfinished(file_.name);
        file_.name.clear();
    }

    fs::path path_;
    TemporaryFile file_;  // locked; with a name only where the file system knows no file without one
    bool replaces_;
    bool isPublished_ = false;
};

/// Whether a file is empty or begins as a recording does. False for all that is no regular file, or cannot be read.
bool isRecordingOrEmpty(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return false;
    struct stat status {};
    const bool isFile = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
    std::array<std::uint8_t, kJournalMagic.size()> head{};
    const bool isOurs = ::read(descriptor, head.data(), head.size()) == std::ssize(head) && head == kJournalMagic;
    ::close(descriptor);
    return isFile && (isOurs || status.st_size == 0);
}

/// Whether the name is free, or may be made free.
Expected<void> checkName(const fs::path& path, ExistingFile existing) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(path, ignored))) return {};
    if (existing == ExistingFile::Kept) return unexpected(msg::kJournalExists, displayName(path));
    if (!isRecordingOrEmpty(path)) return unexpected(msg::kJournalNotReplaced, displayName(path));
    if (isBeingRecorded(path)) return unexpected(msg::kJournalInUse, displayName(path));
    return {};
}

}  // namespace

Expected<std::unique_ptr<JournalFile>> createJournalFile(const fs::path& named, ExistingFile existing) {
    if (auto free = checkName(named, existing); !free) return Unexpected{free.error()};
    std::error_code ignored;
    const bool isLink = fs::is_symlink(fs::symlink_status(named, ignored));
    const fs::path path = isLink ? fs::canonical(named, ignored) : named;  // the link stays one
    if (!path.has_filename()) return cannotWrite(path, ENOENT);
    struct stat unused {};  // an impossible name is reported now and not at the end
    if (::stat(path.c_str(), &unused) != 0 && errno != ENOENT) return cannotWrite(path, errno);
    TemporaryFile file;
    if (const int failure = openTemporary(path.parent_path(), file); failure != 0) return cannotWrite(path, failure);
    return std::unique_ptr<JournalFile>(
        new DiskFile(path, std::move(file), existing == ExistingFile::ReplacedIfOurOwn));
}

bool isBeingRecorded(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool isLocked = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(descriptor);
    return isLocked;
}

}  // namespace tactooth

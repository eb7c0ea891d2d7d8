// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/pending_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/files/file_identity.h"
#include "geometry/files/unfinished_files.h"
#include "geometry/files/write_refusal.h"
#include "geometry/util/messages.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// Small writes are buffered up to this size; larger ones go to the system directly.
constexpr std::size_t kBufferBytes = 64 * 1024;
constexpr mode_t kModeBits = 07777;

/// Removes stale files once for each folder that the program writes into.
void removeStaleOnce(const fs::path& folder) {
    static std::mutex mutex;
    static auto* const seen = new std::set<fs::path>;
    const std::lock_guard lock(mutex);
    if (seen->insert(FileIdentity::of(folder).canonicalPath).second) removeStale(folder);
}

}  // namespace

Expected<std::unique_ptr<PendingFile>> PendingFile::open(const fs::path& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (fs::is_directory(status)) {
        return unexpected(msg::kOutputIsFolder, displayName(path));
    }
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        return unexpected(msg::kOutputNotRegular, displayName(path));
    }
    fs::path target = linksFollowed(path);
    if (!target.has_filename()) return cannotWrite(path, ENOENT);
    struct stat unused {};  // an impossible name is reported now and not after the work
    if (::stat(target.c_str(), &unused) != 0 && errno != ENOENT) return cannotWrite(path, errno);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    TemporaryFile file;
    if (const int failure = openTemporary(folder, file); failure != 0) return cannotWrite(path, failure);
    removeStaleOnce(folder);
    return std::unique_ptr<PendingFile>(new PendingFile(path, std::move(target), std::move(file)));
}

PendingFile::PendingFile(fs::path path, fs::path target, TemporaryFile file)
    : path_(std::move(path)), target_(std::move(target)), file_(std::move(file)) {
    buffer_.reserve(kBufferBytes);
}

PendingFile::~PendingFile() {
    if (file_.descriptor < 0) return;
    if (!file_.name.empty()) {
        const auto lock = lockRenames();
        ::unlink(file_.name.c_str());
        unregisterUnfinished(file_.name);
    }
    ::close(file_.descriptor);
}

void PendingFile::write(std::span<const std::byte> bytes) {
    if (buffer_.size() + bytes.size() > kBufferBytes) flush();
    if (bytes.size() < kBufferBytes) {
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    } else if (failure_ == 0) {
        failure_ = writeAll(file_.descriptor, bytes);
    }
}

void PendingFile::flush() {
    if (failure_ == 0) failure_ = writeAll(file_.descriptor, buffer_);
    buffer_.clear();
}

/// Only the superuser may give a file away; for other users the new file stays their own.
int PendingFile::copyModeFrom() const {
    struct stat old {};
    if (::stat(target_.c_str(), &old) != 0) return 0;
    struct stat own {};
    if (::fstat(file_.descriptor, &own) != 0) return errno;
    if (own.st_uid != old.st_uid) (void)!::fchown(file_.descriptor, old.st_uid, static_cast<gid_t>(-1));
    if (own.st_gid != old.st_gid) (void)!::fchown(file_.descriptor, static_cast<uid_t>(-1), old.st_gid);
    return ::fchmod(file_.descriptor, old.st_mode & kModeBits) == 0 ? 0 : errno;
}

Expected<void> PendingFile::finish() {
    flush();
    if (failure_ == 0) failure_ = copyModeFrom();
    // The system may find the disk full or broken when it writes data that it has only buffered.
    if (failure_ == 0 && ::fsync(file_.descriptor) != 0 && errno != EINVAL) failure_ = errno;
    if (failure_ == 0) return {};
    return cannotWrite(path_, failure_);
}

PendingRename PendingFile::naming() const {
    std::error_code ignored;
    const bool isOpen = file_.name.empty();
    return {.from = isOpen ? openFileName(file_.descriptor) : file_.name.string(),
            .isOpen = isOpen,
            .to = target_.string(),
            .spare = randomNameIn(target_.parent_path()).string(),
            .replaces = fs::exists(target_, ignored),
            .backup = {}};
}

void PendingFile::close() {
    if (!file_.name.empty()) unregisterUnfinished(file_.name);
    ::close(std::exchange(file_.descriptor, -1));
    syncFolder(target_.parent_path());
}

Unexpected PendingFile::cannotBeNamed(int reason) const { return cannotWrite(path_, reason); }

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/readable_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

Unexpected cannotOpen(const std::string& name, int reason) {
    if (reason == ENOENT || reason == ENOTDIR) return unexpected(msg::kFileMissing, name);
    if (reason == EACCES || reason == EPERM) return unexpected(msg::kFileNotReadable, name);
    return unexpected(msg::kFileNotOpened, name, systemReason(reason));
}

Unexpected cannotRead(const std::string& name, int reason) {
    return unexpected(msg::kReadingStopped, name, systemReason(reason));
}

}  // namespace

Expected<ReadableFile> ReadableFile::open(const std::filesystem::path& path) {
    std::string name = displayName(path);
    // Without O_NONBLOCK, opening a named pipe that has no writer would wait for ever.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return cannotOpen(name, errno);
    ReadableFile file(descriptor, std::move(name));
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return cannotRead(file.name_, errno);
    if (S_ISDIR(status.st_mode)) return unexpected(msg::kFileIsFolder, file.name_);
    if (!S_ISREG(status.st_mode)) return unexpected(msg::kFileNotRegular, file.name_);
    file.size_ = static_cast<std::uint64_t>(status.st_size);
    return file;
}

ReadableFile::ReadableFile(ReadableFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_), name_(std::move(other.name_)) {}

ReadableFile::~ReadableFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

Expected<std::size_t> ReadableFile::readAt(std::uint64_t offset, std::span<std::byte> bytes) const {
    TACTOOTH_ASSERT(descriptor_ >= 0);
    TACTOOTH_ASSERT(offset <= static_cast<std::uint64_t>(std::numeric_limits<off_t>::max()) - bytes.size());
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count =
            ::pread(descriptor_, bytes.data() + filled, bytes.size() - filled, static_cast<off_t>(offset + filled));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return cannotRead(name_, errno);
        if (count == 0) break;
        filled += static_cast<std::size_t>(count);
    }
    return filled;
}

}  // namespace tactooth

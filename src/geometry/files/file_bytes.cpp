// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "geometry/util/display_text.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

/// A file descriptor that is closed at the end of its life.
class Descriptor {
public:
    // Without O_NONBLOCK, opening a named pipe that has no writer would wait for ever.
    explicit Descriptor(const std::filesystem::path& path)
        : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] bool valid() const { return fd_ >= 0; }
    [[nodiscard]] int get() const { return fd_; }

private:
    int fd_;
};

Unexpected cannotOpen(const std::string& name, int reason) {
    if (reason == ENOENT || reason == ENOTDIR) return unexpected(msg::kFileMissing, name);
    if (reason == EACCES || reason == EPERM) return unexpected(msg::kFileNotReadable, name);
    return unexpected(msg::kFileNotOpened, name, systemReason(reason));
}

Unexpected cannotRead(const std::string& name, int reason) {
    return unexpected(msg::kReadingStopped, name, systemReason(reason));
}

Expected<std::size_t> sizeOfRegularFile(const Descriptor& file, const std::string& name) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) return cannotRead(name, errno);
    if (S_ISDIR(status.st_mode)) return unexpected(msg::kFileIsFolder, name);
    if (!S_ISREG(status.st_mode)) return unexpected(msg::kFileNotRegular, name);
    if (status.st_size == 0) return unexpected(msg::kFileEmpty, name);
    return static_cast<std::size_t>(status.st_size);
}

}  // namespace

Expected<FileBytes> readFile(const std::filesystem::path& path, std::size_t most) {
    const std::string name = displayName(path);
    const Descriptor file(path);
    if (!file.valid()) return cannotOpen(name, errno);
    const Expected<std::size_t> size = sizeOfRegularFile(file, name);
    if (!size) return unexpected(size.error());
    if (*size > most) {
        return unexpected(msg::kFileTooLong, name, *size, most);
    }

    auto* const data = static_cast<std::byte*>(allocateOnLargePages(*size));
    if (data == nullptr) return unexpected(msg::kFileTooLargeForMemory, name, *size);
    std::size_t filled = 0;
    FileBytes whole(data, *size);
    while (filled < *size) {
        const ssize_t count = ::read(file.get(), data + filled, *size - filled);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return cannotRead(name, errno);
        if (count == 0) break;  // the file has become shorter meanwhile; its parser reports what is missing
        filled += static_cast<std::size_t>(count);
    }
    whole.shorten(filled);
    return whole;
}

std::string displayName(const std::filesystem::path& path) { return displayText(path.native()); }

std::string displayFileName(const std::filesystem::path& path) {
    const std::filesystem::path plain = path.lexically_normal();
    return displayName(plain.has_filename() ? plain.filename() : plain.parent_path().filename());
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "geometry/util/display_text.h"

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
    if (reason == ENOENT || reason == ENOTDIR)
        return unexpected(name + ": there is no such file; check the name and the folder.");
    if (reason == EACCES || reason == EPERM)
        return unexpected(name + ": this user may not read the file; change its permissions.");
    return unexpected(name + ": the file cannot be opened: " + std::generic_category().message(reason) + ".");
}

Unexpected cannotRead(const std::string& name, int reason) {
    return unexpected(name + ": reading stopped: " + std::generic_category().message(reason) + ".");
}

Expected<std::size_t> sizeOfRegularFile(const Descriptor& file, const std::string& name) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) return cannotRead(name, errno);
    if (S_ISDIR(status.st_mode)) return unexpected(name + ": this is a folder; name a file inside it.");
    if (!S_ISREG(status.st_mode))
        return unexpected(name + ": this is not a regular file (a device or a pipe); name a file on disk.");
    if (status.st_size == 0) return unexpected(name + ": the file is empty; export or copy it again.");
    return static_cast<std::size_t>(status.st_size);
}

}  // namespace

Expected<FileBytes> readFile(const std::filesystem::path& path, std::size_t most) {
    const std::string name = displayName(path);
    const Descriptor file(path);
    if (!file.valid()) return cannotOpen(name, errno);
    const Expected<std::size_t> size = sizeOfRegularFile(file, name);
    if (!size) return unexpected(size.error().message);
    if (*size > most) {
        return unexpected(name + ": the file holds " + std::to_string(*size) + " bytes, and at most " +
                          std::to_string(most) + " are read of such a file; choose another or a smaller one.");
    }

    auto* const data = static_cast<std::byte*>(allocateOnLargePages(*size));
    if (data == nullptr)
        return unexpected(name + ": the file (" + std::to_string(*size) + " bytes) does not fit into memory.");
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

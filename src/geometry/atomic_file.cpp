// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "geometry/byte_text.h"
#include "geometry/file_bytes.h"

namespace tactooth {
namespace {

/// Small writes are gathered up to this size; larger ones go to the system as they are.
constexpr std::size_t kBufferBytes = 64 * 1024;

Unexpected cannotWrite(const std::filesystem::path& path, int reason) {
    const std::string name = shownName(path);
    if (reason == ENOENT || reason == ENOTDIR)
        return unexpected(name + ": cannot be written: its folder does not exist; make the folder first.");
    if (reason == EACCES || reason == EPERM || reason == EROFS) {
        return unexpected(name + ": cannot be written: this user may not write into its folder; choose another one.");
    }
    return unexpected(name + ": cannot be written: " + std::generic_category().message(reason) + ".");
}

int writeAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return errno;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

}  // namespace

std::filesystem::path temporaryNameBeside(const std::filesystem::path& target) {
    static std::atomic<unsigned> counter{0};
    return target.parent_path() /
           (".tactooth-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
}

Expected<AtomicFile> AtomicFile::create(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    if (std::filesystem::is_directory(status)) {
        return unexpected(shownName(path) + ": cannot be written: this is a folder; name a file inside it.");
    }
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        return unexpected(shownName(path) + ": cannot be written: this is not a regular file; choose another name.");
    }
    std::filesystem::path target = std::filesystem::exists(status) ? std::filesystem::canonical(path, ignored) : path;
    std::filesystem::path temporary = temporaryNameBeside(target);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return cannotWrite(path, errno);
    return AtomicFile(std::move(target), std::move(temporary), descriptor);
}

AtomicFile::AtomicFile(std::filesystem::path target, std::filesystem::path temporary, int descriptor)
    : target_(std::move(target)), temporary_(std::move(temporary)), descriptor_(descriptor) {
    buffer_.reserve(kBufferBytes);
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      failure_(other.failure_),
      buffer_(std::move(other.buffer_)) {}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::write(std::span<const std::byte> bytes) {
    if (buffer_.size() + bytes.size() > kBufferBytes) flush();
    if (bytes.size() < kBufferBytes) {
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    } else if (failure_ == 0) {
        failure_ = writeAll(descriptor_, bytes);
    }
}

void AtomicFile::write(std::string_view text) { write(asBytes(text)); }

void AtomicFile::flush() {
    if (failure_ == 0) failure_ = writeAll(descriptor_, buffer_);
    buffer_.clear();
}

Expected<void> AtomicFile::commit() {
    assert(descriptor_ >= 0);
    flush();
    if (::close(std::exchange(descriptor_, -1)) != 0 && failure_ == 0) failure_ = errno;
    if (failure_ == 0 && ::rename(temporary_.c_str(), target_.c_str()) != 0) failure_ = errno;
    if (failure_ == 0) return {};
    ::unlink(temporary_.c_str());
    return cannotWrite(target_, failure_);
}

void AtomicFile::discard() {
    if (descriptor_ < 0) return;
    ::close(std::exchange(descriptor_, -1));
    ::unlink(temporary_.c_str());
}

Expected<void> writeFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    Expected<AtomicFile> file = AtomicFile::create(path);
    if (!file) return Unexpected{file.error()};
    file->write(bytes);
    return file->commit();
}

Expected<void> writeFile(const std::filesystem::path& path, std::string_view text) {
    return writeFile(path, asBytes(text));
}

}  // namespace tactooth

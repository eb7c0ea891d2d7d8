// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/files/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>

#include "geometry/files/unfinished_files.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".tactooth-", kSuffix = ".tmp";
constexpr std::size_t kDigits = 16;
constexpr mode_t kUsualMode = 0666;  // less the user's umask
constexpr mode_t kPrivateMode = 0600;
constexpr int kMaxTries = 100;  // 64 random bits do not repeat, but another program may remove the file as stale

std::uint64_t randomBits() {
    std::uint64_t bits = 0;
    if (::getrandom(&bits, sizeof bits, GRND_NONBLOCK) == sizeof bits) return bits;
    static std::uint64_t counter = 0;  // for the time right after the start of the system, before it has random numbers
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    return static_cast<std::uint64_t>(now) * 0x9E3779B97F4A7C15 + static_cast<std::uint64_t>(::getpid()) + ++counter;
}

const char* nameOrDot(const fs::path& folder) { return folder.empty() ? "." : folder.c_str(); }

/// Whether the open file still has a name: another program may have removed it as stale before it was locked.
bool hasName(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

/// Removes one entry if its writer is dead.
void removeIfStale(const fs::path& path) {
    struct stat named {};
    if (::lstat(path.c_str(), &named) != 0 || named.st_uid != ::geteuid()) return;
    const bool isFolder = S_ISDIR(named.st_mode);
    if (!isFolder && !S_ISREG(named.st_mode)) return;
    const int flags = isFolder ? O_RDONLY | O_DIRECTORY : O_RDWR | O_NONBLOCK;
    const int descriptor = ::open(path.c_str(), flags | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return;
    struct stat opened {};
    const bool isSame = ::fstat(descriptor, &opened) == 0 && opened.st_ino == named.st_ino;
    if (isSame && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    ::close(descriptor);
}

}  // namespace

fs::path randomNameIn(const fs::path& folder) {
    std::array<char, kDigits + 1> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(randomBits()));
    return folder / std::string(kPrefix).append(digits.data()).append(kSuffix);
}

bool isRandomName(std::string_view name) {
    if (name.size() != kPrefix.size() + kDigits + kSuffix.size()) return false;
    const std::string_view digits = name.substr(kPrefix.size(), kDigits);
    return name.starts_with(kPrefix) && name.ends_with(kSuffix) &&
           digits.find_first_not_of("0123456789abcdef") == digits.npos;
}

namespace {

int openUnnamed(const fs::path& folder, TemporaryFile& file, mode_t mode) {
    const int descriptor = ::open(nameOrDot(folder), O_WRONLY | O_TMPFILE | O_CLOEXEC, mode);
    if (descriptor < 0) return errno;
    if (::access(openFileName(descriptor).c_str(), F_OK) != 0) {  // without /proc it could never get a name
        ::close(descriptor);
        return ENOTSUP;
    }
    // No other process has the file, so this fails only where there are no locks.
    (void)::flock(descriptor, LOCK_EX | LOCK_NB);
    file = {descriptor, {}};
    return 0;
}

int openNamed(const fs::path& folder, TemporaryFile& file, mode_t mode) {
    const auto lock = lockRenames();
    for (int i = 0; i < kMaxTries; ++i) {
        const fs::path name = randomNameIn(folder);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
        if (descriptor < 0 && errno == EEXIST) continue;
        if (descriptor < 0) return errno;
        (void)::flock(descriptor, LOCK_EX);  // waits for a program that removes stale files, and for no other
        if (hasName(descriptor)) {
            registerUnfinished(name, Unfinished::File);
            file = {descriptor, name};
            return 0;
        }
        ::close(descriptor);
    }
    return EEXIST;
}

}  // namespace

int openUnnamed(const fs::path& folder, TemporaryFile& file) { return openUnnamed(folder, file, kUsualMode); }

int openNamed(const fs::path& folder, TemporaryFile& file) { return openNamed(folder, file, kUsualMode); }

int openTemporary(const fs::path& folder, TemporaryFile& file) {
    return openUnnamed(folder, file) == 0 ? 0 : openNamed(folder, file);
}

int openPrivateTemporary(const fs::path& folder, TemporaryFile& file) {
    return openUnnamed(folder, file, kPrivateMode) == 0 ? 0 : openNamed(folder, file, kPrivateMode);
}

int writeAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return errno;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

std::string openFileName(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

int linkUnnamed(int descriptor, const char* name) {
    const std::string from = openFileName(descriptor);
    return ::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
}

int lockFolder(const fs::path& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor >= 0) (void)::flock(descriptor, LOCK_EX);
    return descriptor;
}

void removeStale(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(nameOrDot(folder), ignored)) {
        if (isRandomName(entry.path().filename().native())) removeIfStale(entry.path());
    }
}

void syncFolder(const fs::path& folder) {
    const int descriptor = ::open(nameOrDot(folder), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    (void)::fsync(descriptor);  // some file systems do not support it; the names exist all the same
    ::close(descriptor);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <utility>

#include "devices/process/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

/// Null where the system refuses.
void* mapFile(int file) {
    void* const place = mmap(nullptr, sizeof(HandLink), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    return place == MAP_FAILED ? nullptr : place;
}

}  // namespace

Expected<HandMemory> HandMemory::create() {
    const int file = memfd_create("tactooth-hand", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    // Neither side may make it shorter: the other one would end by SIGBUS.
    const bool isSized = file >= 0 && ftruncate(file, sizeof(HandLink)) == 0 &&
                         fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) == 0;
    void* const place = isSized ? mapFile(file) : nullptr;
    if (place == nullptr) {
        const Message reason = systemReason(errno);
        if (file >= 0) ::close(file);
        return unexpected(msg::kHandNoMemory, reason);
    }
    return HandMemory(file, new (place) HandLink());
}

std::unique_ptr<HandMemory> HandMemory::open(int file) {
    struct stat facts {};
    const bool fits = fstat(file, &facts) == 0 && facts.st_size == static_cast<off_t>(sizeof(HandLink));
    void* const place = fits ? mapFile(file) : nullptr;
    if (place == nullptr) return nullptr;
    auto* const link = std::launder(static_cast<HandLink*>(place));
    if (!hasSameLayout(*link)) {
        munmap(place, sizeof(HandLink));
        return nullptr;
    }
    fcntl(file, F_SETFD, FD_CLOEXEC);
    return std::unique_ptr<HandMemory>(new HandMemory(file, link));
}

HandMemory::HandMemory(HandMemory&& other) noexcept
    : file_(std::exchange(other.file_, -1)), link_(std::exchange(other.link_, nullptr)) {}

HandMemory::~HandMemory() {
    if (link_ != nullptr) munmap(link_, sizeof(HandLink));
    if (file_ >= 0) ::close(file_);
}

}  // namespace tactooth

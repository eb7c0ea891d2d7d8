// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/memory_sound_file.h"

#include <algorithm>

namespace tactooth {

namespace {

MemoryFile& memoryOf(void* user) { return *static_cast<MemoryFile*>(user); }

sf_count_t lengthOf(void* user) { return static_cast<sf_count_t>(memoryOf(user).bytes.size()); }

sf_count_t tell(void* user) { return static_cast<sf_count_t>(memoryOf(user).place); }

sf_count_t seek(sf_count_t offset, int whence, void* user) {
    const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? tell(user) : lengthOf(user);
    memoryOf(user).place = static_cast<std::size_t>(std::max<sf_count_t>(0, from + offset));
    return tell(user);
}

sf_count_t read(void* into, sf_count_t count, void* user) {
    MemoryFile& file = memoryOf(user);
    const std::size_t left = file.bytes.size() - std::min(file.place, file.bytes.size());
    const std::size_t size = std::min(static_cast<std::size_t>(std::max<sf_count_t>(0, count)), left);
    std::copy_n(file.bytes.data() + std::min(file.place, file.bytes.size()), size, static_cast<std::byte*>(into));
    file.place += size;
    return static_cast<sf_count_t>(size);
}

sf_count_t write(const void* from, sf_count_t count, void* user) {
    MemoryFile& file = memoryOf(user);
    const auto size = static_cast<std::size_t>(count);
    file.bytes.resize(std::max(file.bytes.size(), file.place + size));
    std::copy_n(static_cast<const std::byte*>(from), size, file.bytes.data() + file.place);
    file.place += size;
    return count;
}

}  // namespace

SoundFile openInMemory(MemoryFile& file, int mode, SF_INFO& info) {
    SF_VIRTUAL_IO io{lengthOf, seek, read, write, tell};
    return SoundFile(sf_open_virtual(&io, mode, &info, &file));
}

}  // namespace tactooth

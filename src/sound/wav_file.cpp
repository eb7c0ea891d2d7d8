// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/wav_file.h"

#include <sndfile.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "geometry/atomic_file.h"
#include "sound/sound_format.h"

namespace tactooth {

namespace {

// A file in memory that libsndfile writes to: it has to go back to the head at the end, which AtomicFile cannot.
struct MemoryFile {
    std::vector<std::byte> bytes;
    std::size_t place = 0;
};

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
    const std::size_t size = std::min(static_cast<std::size_t>(count), left);
    std::copy_n(file.bytes.data() + file.place, size, static_cast<std::byte*>(into));
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

struct CloseSoundFile {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

}  // namespace

Expected<std::vector<std::byte>> wavBytes(std::span<const float> stereo) {
    SF_INFO info{};
    info.samplerate = kSoundRate;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    SF_VIRTUAL_IO memory{lengthOf, seek, read, write, tell};
    MemoryFile written;
    std::unique_ptr<SNDFILE, CloseSoundFile> file(sf_open_virtual(&memory, SFM_WRITE, &info, &written));
    if (file == nullptr)
        return unexpected(std::string("The sound could not be made into a WAV file: ") + sf_strerror(nullptr));
    sf_command(file.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
    const auto frames = static_cast<sf_count_t>(stereo.size() / 2);
    const bool complete = sf_writef_float(file.get(), stereo.data(), frames) == frames;
    const bool closed = sf_close(file.release()) == 0;
    if (complete && closed) return std::move(written.bytes);
    return unexpected("The sound could not be made into a WAV file, which holds at most 4 GB; make it shorter.");
}

Expected<void> writeWav(const std::filesystem::path& path, std::span<const float> stereo) {
    const Expected<std::vector<std::byte>> bytes = wavBytes(stereo);
    if (!bytes) return unexpected(bytes.error().message);
    return writeFile(path, *bytes);
}

}  // namespace tactooth

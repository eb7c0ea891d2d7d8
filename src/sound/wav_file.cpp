// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/wav_file.h"

#include <string>

#include "geometry/atomic_file.h"
#include "sound/memory_sound_file.h"
#include "sound/sound_format.h"

namespace tactooth {

Expected<std::vector<std::byte>> wavBytes(std::span<const float> stereo) {
    SF_INFO info{};
    info.samplerate = kSoundRate;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    MemoryFile written;
    SoundFile file = openInMemory(written, SFM_WRITE, info);
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

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/wav_file.h"

#include <sndfile.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <system_error>

#include "sound/sound_format.h"

namespace tactooth {

namespace {

struct CloseSoundFile {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

// A name beside `path` that no other running program uses.
std::filesystem::path temporaryNameFor(const std::filesystem::path& path) {
    std::filesystem::path name = path;
    name += ".part" + std::to_string(getpid());
    return name;
}

// What went wrong, or nothing.
std::string writeSamples(const std::filesystem::path& path, std::span<const float> stereo) {
    SF_INFO info{};
    info.samplerate = kSoundRate;
    info.channels = 2;
    info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    std::unique_ptr<SNDFILE, CloseSoundFile> file(sf_open(path.c_str(), SFM_WRITE, &info));
    if (file == nullptr) return sf_strerror(nullptr);
    sf_command(file.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
    const auto frames = static_cast<sf_count_t>(stereo.size() / 2);
    if (sf_writef_float(file.get(), stereo.data(), frames) != frames) return sf_strerror(file.get());
    if (const int failed = sf_close(file.release()); failed != 0) return sf_error_number(failed);
    return {};
}

}  // namespace

Expected<void> writeWav(const std::filesystem::path& path, std::span<const float> stereo) {
    const std::filesystem::path temporary = temporaryNameFor(path);
    std::string problem = writeSamples(temporary, stereo);
    std::error_code failed;
    if (problem.empty()) {
        std::filesystem::rename(temporary, path, failed);
        if (failed) problem = failed.message();
    }
    if (problem.empty()) return {};
    std::filesystem::remove(temporary, failed);
    return unexpected("The sound file \"" + path.string() + "\" could not be written (" + problem +
                      "); give a folder that exists and has room.");
}

}  // namespace tactooth

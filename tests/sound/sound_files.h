// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sndfile.h>

#include <cmath>
#include <filesystem>
#include <vector>

namespace tactooth::test {

/// How a recording is written. `format` as for libsndfile.
struct SoundFileKind {
    int format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    int rate = 48000;
    int channels = 1;
};

/// Writes a tone of `hz` with a bit of overtone for `seconds`, the same on all channels.
inline void writeTone(const std::filesystem::path& path, double hz, double seconds, const SoundFileKind& kind = {}) {
    SF_INFO info{};
    info.format = kind.format;
    info.samplerate = kind.rate;
    info.channels = kind.channels;
    SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
    std::vector<float> frame(static_cast<std::size_t>(kind.channels));
    for (int i = 0; i < static_cast<int>(seconds * kind.rate); ++i) {
        const double angle = 6.283185307179586 * hz * i / kind.rate;
        frame.assign(frame.size(), static_cast<float>(0.3 * std::sin(angle) + 0.1 * std::sin(2.0 * angle)));
        sf_writef_float(file, frame.data(), 1);
    }
    sf_close(file);
}

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "geometry/files/atomic_file.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// Writes alternating left and right samples at kSoundRate to a 16-bit WAV file, chunk by chunk: only one chunk is in
/// memory. The file appears under its name only when it is complete. Samples beyond +-1 are clipped. The file holds the
/// samples and what is needed to play them, nothing else.
class WavWriter {
public:
    /// `frames`: number of sample pairs that will come. Errors: more than the 4 GB that such a file can hold; the
    /// folder is missing or not writable.
    [[nodiscard]] static Expected<WavWriter> create(const std::filesystem::path& path, std::size_t frames);

    void write(std::span<const float> stereo);

    /// Call it once, after all frames. Error: the disk is full.
    [[nodiscard]] Expected<void> commit();

private:
    WavWriter(AtomicFile file, std::size_t samples) : file_(std::move(file)), remaining_(samples) {}

    AtomicFile file_;
    std::size_t remaining_;  ///< samples that are still to come
    std::vector<std::byte> chunk_;
};

/// Writes a whole file at once.
[[nodiscard]] Expected<void> writeWav(const std::filesystem::path& path, std::span<const float> stereo);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "view/render/image.h"

namespace tactooth {

/// The program ffmpeg, if it is installed: the first in PATH.
[[nodiscard]] std::optional<std::filesystem::path> findFfmpeg();

/// Makes a film of pictures and sound by ffmpeg. It works in memory, and writes the film at the end.
class FilmEncoder {
public:
    /// `film`: the file to write; its ending chooses the container. `fps`: pictures each second, of even width and
    /// height. Fails with one sentence if ffmpeg does not start.
    [[nodiscard]] static Expected<std::unique_ptr<FilmEncoder>> start(const std::filesystem::path& ffmpeg,
                                                                      const std::filesystem::path& film, ImageSize size,
                                                                      int fps);
    ~FilmEncoder();
    FilmEncoder(const FilmEncoder&) = delete;
    FilmEncoder& operator=(const FilmEncoder&) = delete;

    /// The next picture. Fails with one sentence if ffmpeg has ended.
    [[nodiscard]] Expected<void> add(const Image& image);
    /// Adds the sound, alternating left and right samples at kSoundRate (none: a silent film), and writes the file.
    [[nodiscard]] Expected<void> finish(std::span<const float> stereo);

private:
    class MemoryFile;
    struct Child {
        pid_t process = 0;  ///< 0: none
        int input = -1;     ///< its standard input, or -1
    };

    FilmEncoder(std::filesystem::path ffmpeg, std::filesystem::path film);
    [[nodiscard]] Expected<Child> run(const std::vector<std::string>& arguments, const std::vector<int>& files,
                                      bool withInput) const;
    [[nodiscard]] Expected<void> waitFor(Child& child) const;
    [[nodiscard]] std::string lastWords() const;

    std::filesystem::path ffmpeg_, film_;
    std::unique_ptr<MemoryFile> errors_, silent_;  // what ffmpeg says; the film without sound
    Child encoder_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/cli/sessions/film_encoder.h"
#include "app/cli/sessions/replay_pictures.h"
#include "session/audio/tick_sound.h"
#include "sound/output/offline_render.h"

namespace tactooth {

struct FilmOptions {
    std::filesystem::path file;  ///< empty: no film
    int fps = 25;                ///< pictures each second of the film
    double speed = 1;            ///< of the film; with another one than 1 it is silent
};

/// A replay as a film with the sound of the drill. Without ffmpeg it becomes a folder of pictures and a WAV file.
class ReplayFilm {
public:
    static constexpr std::uint64_t kMostPictures = 500'000;

    /// Checks the name, the size and the length (s of the session) before anything is simulated. Fails with one
    /// sentence.
    [[nodiscard]] static Expected<void> check(const FilmOptions& options, ImageSize size, double seconds);
    /// Where the pictures go without ffmpeg.
    [[nodiscard]] static std::filesystem::path folderFor(const std::filesystem::path& film);

    /// `ffmpeg`: the program, or nothing; then the folder is there already. Fails with one sentence.
    [[nodiscard]] static Expected<ReplayFilm> start(const FilmOptions& options, ImageSize size,
                                                    const std::optional<std::filesystem::path>& ffmpeg);

    /// After each tick. Fails with one sentence if a picture cannot be made.
    [[nodiscard]] Expected<void> add(const SessionReplay& replay, ReplayPictures& pictures, const Tick& tick,
                                     double time);
    /// Adds the sound and writes the film.
    [[nodiscard]] Expected<void> finish();
    [[nodiscard]] int pictures() const { return count_; }

private:
    explicit ReplayFilm(const FilmOptions& options) : options_(options) {}
    void hear(const BeginEvent& bur, const Tick& tick, double time);
    [[nodiscard]] Expected<void> writeSound();

    FilmOptions options_;
    std::unique_ptr<FilmEncoder> encoder_;  // null: a folder of pictures
    int count_ = 0;                         // of pictures
    double end_ = 0;                        // of the session, s
    std::vector<TimedSoundState> heard_;
    std::optional<TickSound> tickSound_;
    std::shared_ptr<const ToolShape> soundOf_;  // the bur of `tickSound_`
};

}  // namespace tactooth

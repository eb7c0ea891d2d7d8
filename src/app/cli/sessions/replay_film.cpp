// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/replay_film.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "app/cli/sessions/messages.h"
#include "geometry/files/file_bytes.h"
#include "sound/files/wav_file.h"
#include "sound/output/audio_libraries.h"

namespace tactooth {
namespace {

constexpr double kHearing = 0.002;  // s between two states of the sound

}  // namespace

std::filesystem::path ReplayFilm::folderFor(const std::filesystem::path& film) {
    std::filesystem::path folder = film;
    return folder.replace_extension(".frames");
}

Expected<void> ReplayFilm::check(const FilmOptions& options, ImageSize size, double seconds) {
    const std::string ending = options.file.extension().native();
    if (ending != ".mp4" && ending != ".mkv" && ending != ".mov") {
        return unexpected(msg::kFilmEnding, displayName(options.file));
    }
    if (size.width % 2 != 0 || size.height % 2 != 0) {
        return unexpected(msg::kFilmOddSize, fmt::format("{}x{}", size.width, size.height));
    }
    if (!(seconds > 0)) return unexpected(msg::kFilmEmpty, displayName(options.file));
    const double pictures = seconds / options.speed * options.fps;
    if (pictures > static_cast<double>(kMostPictures)) {
        return unexpected(msg::kFilmTooLong, static_cast<std::uint64_t>(pictures), kMostPictures);
    }
    return {};
}

Expected<ReplayFilm> ReplayFilm::start(const FilmOptions& options, ImageSize size,
                                       const std::optional<std::filesystem::path>& ffmpeg) {
    ReplayFilm film(options);
    if (!ffmpeg) return film;
    auto encoder = FilmEncoder::start(*ffmpeg, options.file, size, options.fps);
    if (!encoder) return Unexpected{encoder.error()};
    film.encoder_ = std::move(*encoder);
    return film;
}

Expected<void> ReplayFilm::add(const SessionReplay& replay, ReplayPictures& pictures, const Tick& tick, double time) {
    end_ = time;
    if (replay.bur()) hear(*replay.bur(), tick, time);
    const auto due = [&] { return count_ * options_.speed / options_.fps <= time; };
    if (!due()) return {};
    Expected<Image> image = pictures.draw(replay, tick, time);
    if (!image) return Unexpected{image.error()};
    for (; due(); ++count_) {  // more than one after a gap in the session
        const auto file = folderFor(options_.file) / fmt::format("picture-{:06}.png", count_);
        auto added = encoder_ ? encoder_->add(*image) : writePng(*image, file);
        if (!added) return added;
    }
    return {};
}

void ReplayFilm::hear(const BeginEvent& bur, const Tick& tick, double time) {
    if (options_.speed != 1) return;
    if (std::exchange(soundOf_, bur.instrument.shape) != bur.instrument.shape || !tickSound_) {
        tickSound_.emplace(bur.settings.spindle, bur.settings.materials, bur.instrument.edge);
    }
    if (heard_.empty() || time >= heard_.back().time + kHearing) heard_.push_back({time, tickSound_->at(tick), {}});
}

Expected<void> ReplayFilm::finish() {
    if (!encoder_) return writeSound();
    StereoSamples stereo;
    if (!heard_.empty() && end_ <= kMaxSoundLength) {
        prepareAudioLibraries();
        Expected<StereoSamples> rendered = renderOffline(heard_, end_);
        if (!rendered) return Unexpected{rendered.error()};
        stereo = std::move(*rendered);
    }
    return encoder_->finish(stereo);
}

Expected<void> ReplayFilm::writeSound() {
    if (heard_.empty() || end_ > kMaxSoundLength) return {};
    prepareAudioLibraries();
    auto wav = WavWriter::create(folderFor(options_.file) / "sound.wav", framesOf(end_));
    if (!wav) return Unexpected{wav.error()};
    auto rendered = renderInChunks(heard_, end_, {}, [&](std::span<const float> stereo) { wav->write(stereo); });
    if (!rendered) return rendered;
    return wav->commit();
}

}  // namespace tactooth

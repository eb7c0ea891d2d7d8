// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/replay_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/pictures/render_arguments.h"
#include "app/cli/sessions/replay_pictures.h"
#include "app/cli/sessions/seal_text.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/display_text.h"
#include "session/io/tick_csv.h"
#include "session/recording/session_replay.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

/// All files that are written, but for a film's pictures without ffmpeg: all of them, or none.
class ReplayFiles {
public:
    [[nodiscard]] Expected<void> open(const ReplayOptions& options) {
        set_.reads(options.session);
        if (!options.film.file.empty()) {
            ffmpeg_ = findFfmpeg();
            auto opened =
                ffmpeg_ ? set_.open(options.film.file) : set_.makeFolder(ReplayFilm::folderFor(options.film.file));
            if (!opened) return opened;
        }
        if (options.out.empty()) return {};
        if (auto made = set_.makeFolder(options.out); !made) return made;
        for (const char* name : {"cut.stl", "forces.csv", "summary.json"}) {
            if (auto opened = set_.open(options.out / name); !opened) return opened;
        }
        for (int i = 1; i <= options.pictures; ++i) {
            if (auto opened = set_.open(pictureFile(options, i)); !opened) return opened;
        }
        auto file = TickCsv::create(options.out / "forces.csv");
        if (!file) return Unexpected{file.error()};
        forces_.emplace(std::move(*file));
        return {};
    }
    void row(double time, const Tick& tick) {
        if (forces_) forces_->write(time, tick);
    }
    [[nodiscard]] Expected<void> finish(const ReplayOptions& options, const CutModel& model, const Json& summary) {
        if (!options.out.empty()) {
            if (auto done = writeStl(model.exported().mesh, options.out / "cut.stl"); !done) return done;
            if (auto done = forces_->commit(); !done) return done;
            if (auto done = writeFile(options.out / "summary.json", summary.dump(2) + "\n"); !done) return done;
        }
        return set_.commit();
    }
    [[nodiscard]] const std::optional<std::filesystem::path>& ffmpeg() const { return ffmpeg_; }
    [[nodiscard]] static std::filesystem::path pictureFile(const ReplayOptions& options, int number) {
        return numberedFile(options.out / "picture.png", number);
    }

private:
    FileTransaction set_;
    std::optional<TickCsv> forces_;
    std::optional<std::filesystem::path> ffmpeg_;
};

/// The pictures and the film of a replay. Without either it does nothing.
class ReplayShow {
public:
    [[nodiscard]] Expected<void> open(const ReplayOptions& options, const SessionRecording& recording,
                                      const CutModel& model, const ReplayFiles& files) {
        options_ = &options;
        if (options.pictures == 0 && options.film.file.empty()) return {};
        const Expected<ImageSize> size = parseSize(options.size);
        if (!size) return Unexpected{size.error()};
        const Expected<double> seconds = recording.seconds();
        if (!seconds) return Unexpected{seconds.error()};
        seconds_ = std::min(*seconds, options.until.value_or(*seconds));
        if (!options.film.file.empty()) {
            if (auto fits = ReplayFilm::check(options.film, *size, seconds_); !fits) return fits;
        }
        Expected<ReplayPictures> pictures = ReplayPictures::create(options.view, *size, recording, model);
        if (!pictures) return Unexpected{pictures.error()};
        pictures_.emplace(std::move(*pictures));
        if (options.film.file.empty()) return {};
        Expected<ReplayFilm> film = ReplayFilm::start(options.film, *size, files.ffmpeg());
        if (!film) return Unexpected{film.error()};
        film_.emplace(std::move(*film));
        return {};
    }
    /// After each tick. The first failure counts.
    void add(const SessionReplay& replay, const Tick& tick, double time) {
        if (!pictures_ || !done_) return;
        last_ = {tick, time};
        while (done_ && drawn_ < options_->pictures && time >= seconds_ * (drawn_ + 1) / options_->pictures)
            draw(replay);
        if (film_ && done_) done_ = film_->add(replay, *pictures_, tick, time);
    }
    [[nodiscard]] Expected<void> finish(const SessionReplay& replay) {
        while (pictures_ && done_ && drawn_ < options_->pictures)
            draw(replay);  // rounding, or a recording that differs
        if (film_ && done_) done_ = film_->finish();
        return done_;
    }
    [[nodiscard]] int filmPictures() const { return film_ ? film_->pictures() : 0; }

private:
    void draw(const SessionReplay& replay) {
        const Expected<Image> image = pictures_->draw(replay, last_.tick, last_.time);
        if (!image) {
            done_ = Unexpected{image.error()};
            return;
        }
        done_ = writePng(*image, ReplayFiles::pictureFile(*options_, ++drawn_));
    }

    struct Moment {
        Tick tick;
        double time = 0;  // s
    };

    const ReplayOptions* options_ = nullptr;
    double seconds_ = 0;
    std::optional<ReplayPictures> pictures_;
    std::optional<ReplayFilm> film_;
    Moment last_;
    int drawn_ = 0;
    Expected<void> done_;
};

Json summaryOf(const SessionReplay& replay, const SessionRecording& recording, double wallSeconds) {
    Json removed = Json::object();
    const CutModel& model = replay.model();
    for (const MaterialId id : model.tooth().materials().byRole()) {
        removed[std::string(model.tooth().materials().nameOf(id))] = model.removed()[static_cast<std::size_t>(id)];
    }
    const Expected<RecordedEnd> end = recording.end();
    const bool hasGap = end && end->hasGap;
    Json json = {{"title", recording.facts().title},
                 {"complete", recording.journal().isComplete() && !hasGap},
                 {"gap", hasGap},
                 {"seconds", replay.seconds()},
                 {"ticks", replay.ticks()},
                 {"speed", replay.seconds() / std::max(wallSeconds, 1e-9)},
                 {"removed_mm3", removed},
                 {"hash", fmt::format("{:016x}", model.hash())},
                 {"same", !replay.differsAt()}};
    if (replay.differsAt()) json["differs_at_s"] = *replay.differsAt();
    return json;
}

void printSummary(const Json& summary, const std::string& recordedBy) {
    print("{:.1f} s of '{}' in {} ticks, {:.1f} times as fast as it was recorded\n", summary["seconds"].get<double>(),
          displayText(summary["title"].get<std::string>()), summary["ticks"].get<std::uint64_t>(),
          summary["speed"].get<double>());
    for (const auto& [material, volume] : summary["removed_mm3"].items()) {
        if (volume.get<double>() > 0) print("removed {:>12}: {:8.3f} mm^3\n", material, volume.get<double>());
    }
    if (summary["gap"].get<bool>()) {
        print("The recording has a gap, because that computer was too slow: this is what was before it.\n");
    } else if (!summary["complete"].get<bool>()) {
        print("The recording was cut off: this is what was left of it.\n");
    }
    if (summary["same"].get<bool>()) {
        print("The tooth, the forces and the events are those of the recording, bit for bit.\n");
    } else {
        print("The replay differs from the recording from {:.0f} s on. It was recorded by {}.\n",
              std::floor(summary["differs_at_s"].get<double>()), displayText(recordedBy));
    }
}

void printFilm(const ReplayOptions& options, int pictures, bool hasFfmpeg) {
    if (hasFfmpeg) return print("{}: {} pictures\n", displayName(options.film.file), pictures);
    print("{}: {} pictures and the sound. ffmpeg is not installed; with it they become a film.\n",
          displayName(ReplayFilm::folderFor(options.film.file)), pictures);
}

}  // namespace

int runReplay(const ReplayOptions& options) {
    ReplayFiles files;
    if (const auto opened = files.open(options); !opened) return reportError(opened.error());
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    Expected<SessionReplay> replay = SessionReplay::start(*recording);
    if (!replay) return reportError(replay.error());
    ReplayShow show;
    if (const auto opened = show.open(options, *recording, replay->model(), files); !opened) {
        return reportError(opened.error());
    }
    const auto start = std::chrono::steady_clock::now();
    const auto row = [&](double time, const Tick& tick) {
        files.row(time, tick);
        show.add(*replay, tick, time);
    };
    if (const auto played = replay->playUntil(options.until, row); !played) return reportError(played.error());
    if (const auto shown = show.finish(*replay); !shown) return reportError(shown.error());
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    Json summary = summaryOf(*replay, *recording, wall);
    if (options.seal) summary["seal"] = sealJson(*options.seal);
    if (const auto written = files.finish(options, replay->model(), summary); !written) {
        return reportError(written.error());
    }
    if (options.json) {
        print("{}\n", summary.dump(2));
    } else {
        if (options.seal && options.seal->verdict != SealReport::Verdict::NotSealed)
            print("{}\n", sealText(*options.seal));
        printSummary(summary, recording->facts().commit + ", " + recording->facts().compiler);
        if (!options.film.file.empty()) printFilm(options, show.filmPictures(), files.ffmpeg().has_value());
    }
    return replay->differsAt() ? kExitNegative : kExitOk;
}

}  // namespace tactooth

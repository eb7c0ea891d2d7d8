// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sessions/replay_command.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_transaction.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/display_text.h"
#include "session/io/tick_csv.h"
#include "session/recording/session_replay.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

/// The files of --out: all of them, or none.
class ReplayFiles {
public:
    [[nodiscard]] Expected<void> open(const ReplayOptions& options) {
        if (options.out.empty()) return {};
        set_.reads(options.session);
        if (auto made = set_.makeFolder(options.out); !made) return made;
        for (const char* name : {"cut.stl", "forces.csv", "summary.json"}) {
            if (auto opened = set_.open(options.out / name); !opened) return opened;
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
        if (options.out.empty()) return {};
        if (auto done = writeStl(model.exported().mesh, options.out / "cut.stl"); !done) return done;
        if (auto done = forces_->commit(); !done) return done;
        if (auto done = writeFile(options.out / "summary.json", summary.dump(2) + "\n"); !done) return done;
        return set_.commit();
    }

private:
    FileTransaction set_;
    std::optional<TickCsv> forces_;
};

Json summaryOf(const SessionReplay& replay, const SessionRecording& recording, double wallSeconds) {
    Json removed = Json::object();
    const CutModel& model = replay.model();
    for (const MaterialId id : model.tooth().materials().byRole()) {
        removed[std::string(model.tooth().materials().nameOf(id))] = model.removed()[static_cast<std::size_t>(id)];
    }
    Json json = {{"title", recording.facts().title},
                 {"complete", recording.journal().isComplete()},
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
    if (!summary["complete"].get<bool>()) print("The recording was cut off: this is what was left of it.\n");
    if (summary["same"].get<bool>()) {
        print("The tooth, the forces and the events are those of the recording, bit for bit.\n");
    } else {
        print("The replay differs from the recording from {:.0f} s on. It was recorded by {}.\n",
              std::floor(summary["differs_at_s"].get<double>()), displayText(recordedBy));
    }
}

}  // namespace

int runReplay(const ReplayOptions& options) {
    ReplayFiles files;
    if (const auto opened = files.open(options); !opened) return reportError(opened.error());
    const Expected<SessionRecording> recording = SessionRecording::open(options.session);
    if (!recording) return reportError(recording.error());
    const auto start = std::chrono::steady_clock::now();
    Expected<SessionReplay> replay = SessionReplay::start(*recording);
    if (!replay) return reportError(replay.error());
    const auto row = [&](double time, const Tick& tick) { files.row(time, tick); };
    if (const auto played = replay->playUntil(options.until, row); !played) return reportError(played.error());
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Json summary = summaryOf(*replay, *recording, wall);
    if (const auto written = files.finish(options, replay->model(), summary); !written) {
        return reportError(written.error());
    }
    if (options.json) {
        print("{}\n", summary.dump(2));
    } else {
        printSummary(summary, recording->facts().commit + ", " + recording->facts().compiler);
    }
    return replay->differsAt() ? kExitNegative : kExitOk;
}

}  // namespace tactooth

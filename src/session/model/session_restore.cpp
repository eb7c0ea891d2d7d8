// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_restore.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/files/file_bytes.h"
#include "session/kernel/session_kernel.h"
#include "session/model/spin_envelope_mesh.h"
#include "session/model/work_history.h"
#include "session/recording/messages.h"
#include "session/recording/session_recording.h"

namespace tactooth {
namespace {

/// No tooth has lost so little: whatever is gone is unsaved.
MaterialVolumes neverSaved() {
    MaterialVolumes none;
    none.fill(-1);
    return none;
}

/// A recording that is simulated again as far as it goes.
class Restoration {
public:
    Restoration(const SessionRecording& recording, std::shared_ptr<CutModel> model, RestoreProgress& progress)
        : recording_(recording),
          progress_(progress),
          model_(std::move(model)),
          kernel_(model_),
          work_(recording.work().value_or(SessionWork())),
          events_(model_->tooth().materials(), work_.events) {}

    [[nodiscard]] Expected<void> play() {
        return recording_.forEach([this](const SessionEvent& event) { return apply(event); });
    }
    [[nodiscard]] bool isStopped() const { return progress_.stops; }

    [[nodiscard]] Expected<SessionTooth> tooth() {
        // As from a file: only what was not cut since it was opened can be recorded exactly.
        const std::vector<std::byte> bytes = toothFileBytes(*model_, {});
        Expected<OpenedTooth> fresh = parseTooth(bytes, recording_.journal().name(), model_->tooth().materials());
        if (!fresh) return Unexpected{fresh.error()};
        fresh->piece->surroundBy(model_->surroundings());
        SessionTooth tooth;
        tooth.name = work_.title.empty() ? recording_.facts().title : work_.title;
        tooth.piece = std::move(fresh->piece);
        tooth.mesialX = tooth.piece->tooth().toothContext().mesialX;
        tooth.workBox = tooth.piece->tooth().ownBox();
        tooth.provenance = {{"tooth", tooth.name}, {"restored", "from the recording of a session that was cut off"}};
        tooth.bur = bur();
        tooth.savedAt = neverSaved();
        tooth.wasUnsaved = true;
        work_.seconds += seconds_;
        work_.events = events_.all();
        tooth.work = work_;
        if (isPermanentTooth(work_.mouthTooth)) {
            if (auto done = putIntoMouth(tooth, work_.mouthTooth); !done) return Unexpected{done.error()};
        }
        if (differs_) {
            const auto whole = [](double seconds) { return static_cast<std::int64_t>(std::floor(seconds)); };
            const double all = seconds_ * static_cast<double>(recording_.ticks()) /
                               static_cast<double>(std::max<std::uint64_t>(ticks_, 1));
            tooth.importNotes.push_back({ImportNoteTopic::File, {msg::kRestoredInPart, whole(seconds_), whole(all)}});
        }
        return tooth;
    }

private:
    bool apply(const SessionEvent& event) {
        if (isStopped()) return false;
        if (const auto* const begin = std::get_if<BeginEvent>(&event)) {
            instrument_ = begin->instrument;
            began_ = now();
        }
        const auto* const edit = std::get_if<EditEvent>(&event);
        differs_ = !kernel_.apply(event);
        if (differs_) return false;
        const auto* const carve = std::get_if<CarveEvent>(&event);
        if ((edit != nullptr && edit->published) || (carve != nullptr && carve->published)) {
            history_.follow(model_->history(), events_, now(), began_);
        }
        const auto* const tick = std::get_if<TickEvent>(&event);
        if (tick == nullptr) return true;
        seconds_ += tick->input.seconds();
        events_.update(now(), kernel_.tick(), kernel_.model().loss());
        constexpr std::uint64_t kOften = 256;  // ticks
        if (++ticks_ % kOften == 0) {
            progress_.part = static_cast<double>(ticks_) / static_cast<double>(recording_.ticks());
        }
        return true;
    }

    /// On the time scale of the events, s.
    [[nodiscard]] double now() const { return work_.seconds + seconds_; }

    /// That of the catalogue if it is one, as it has a finer picture.
    std::optional<SessionBur> bur() const {
        if (instrument_ && instrument_->hand) return makeHandInstrument(*instrument_->hand);
        if (std::optional<SessionBur> known = burOf(work_, {})) return known;
        if (!instrument_) return std::nullopt;
        return withHead({work_.bur, *instrument_, std::make_shared<const TriangleMesh>(instrument_->shape->mesh()),
                         std::make_shared<const TriangleMesh>(spinEnvelopeMesh(instrument_->cutting.envelope)),
                         instrument_->edge.flutes == 0 ? BurMaterial::Diamond : BurMaterial::Carbide, work_.burFile});
    }

    const SessionRecording& recording_;
    RestoreProgress& progress_;
    std::shared_ptr<CutModel> model_;
    SessionKernel kernel_;
    SessionWork work_;  // when the recording was described last; its time is that of the beginning
    CutEvents events_;
    WorkHistory history_;  // says which events were taken back
    double began_ = 0;     // when the newest bur began, on the time scale of the events, s
    std::optional<Instrument> instrument_;
    double seconds_ = 0;
    std::uint64_t ticks_ = 0;
    bool differs_ = false;
};

Expected<SessionTooth> restoreRecording(const std::filesystem::path& file, RestoreProgress& progress) {
    const Expected<SessionRecording> recording = SessionRecording::open(file);
    if (!recording) return Unexpected{recording.error()};
    Expected<std::shared_ptr<CutModel>> model = recording->makeModel();
    if (!model) return Unexpected{model.error()};
    Restoration restoration(*recording, std::move(*model), progress);
    if (const auto played = restoration.play(); !played) return Unexpected{played.error()};
    if (restoration.isStopped()) return unexpected(msg::kRestoreStopped, displayName(file));
    return restoration.tooth();
}

Expected<SessionTooth> restoreTooth(const std::filesystem::path& file) {
    Expected<SessionTooth> tooth = loadSessionTooth({.outer = file, .layers = {}});
    if (!tooth) return tooth;
    if (!tooth->work.title.empty()) tooth->name = tooth->work.title;
    tooth->savedAt = neverSaved();
    tooth->wasUnsaved = true;
    return tooth;
}

}  // namespace

std::optional<LeftoverFacts> examine(const Leftover& leftover, const RecordingFolder& folder) {
    if (leftover.kind() == Leftover::Kind::Tooth) {
        const Expected<OpenedTooth> tooth = openTooth(leftover.file());
        if (!tooth) return std::nullopt;  // it stays: a newer version may read it
        return LeftoverFacts{parseWork(tooth->work).value_or(SessionWork()).title};
    }
    const Expected<SessionRecording> recording = SessionRecording::open(leftover.file());
    if (!recording) return std::nullopt;
    if (recording->journal().isComplete()) {  // it ended between its last byte and its new name
        (void)folder.keep(leftover.file(), leftover.time(), recording->facts().title).has_value();
        return std::nullopt;
    }
    const SessionWork work = recording->work().value_or(SessionWork());
    const Expected<bool> isChanged = recording->hasChanges();
    if (!isChanged || !(*isChanged || work.isUnsaved)) {
        if (isChanged) folder.discard(leftover.file());
        return std::nullopt;
    }
    return LeftoverFacts{work.title.empty() ? recording->facts().title : work.title};
}

Expected<SessionTooth> restoreSession(const Leftover& leftover, RestoreProgress& progress) {
    if (leftover.kind() == Leftover::Kind::Tooth) return restoreTooth(leftover.file());
    return restoreRecording(leftover.file(), progress);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/current_work.h"

#include <algorithm>
#include <utility>

#include "app/gui/model/exercise_tooth.h"
#include "app/gui/text/messages.h"
#include "assessment/exercise_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

/// Where a file of that name is; empty: nowhere.
fs::path found(const fs::path& file, const fs::path& folder, const std::vector<fs::path>& known) {
    std::error_code ignored;
    if (file.is_absolute() && fs::exists(file, ignored)) return file;
    if (const fs::path beside = folder / file.filename(); !folder.empty() && fs::exists(beside, ignored)) return beside;
    const auto same =
        std::ranges::find_if(known, [&](const fs::path& one) { return one.filename() == file.filename(); });
    return same != known.end() && fs::exists(*same, ignored) ? *same : fs::path();
}

std::shared_ptr<const Exercise> exerciseOf(const SessionWork& work, const fs::path& folder,
                                           const std::vector<fs::path>& known) {
    if (work.exerciseFile.empty()) {
        const auto same =
            std::ranges::find_if(exercises(), [&](const auto& one) { return one->name == work.exercise; });
        return same != exercises().end() ? *same : nullptr;
    }
    const fs::path file = found(work.exerciseFile, folder, known);
    if (file.empty()) return nullptr;
    Expected<Exercise> read = readExercise(file);
    return read ? std::make_shared<const Exercise>(std::move(*read)) : nullptr;
}

}  // namespace

SessionWork currentWork(const SessionModel& model, const std::shared_ptr<const Exercise>& exercise,
                        const std::string& targetFile) {
    SessionWork work;
    if (!model.tooth()) return work;
    work.title = model.tooth()->name;
    work.mouthTooth = model.tooth()->mouthTooth;
    if (exercise != nullptr) {
        work.exercise = exercise->name;
        std::error_code ignored;
        if (!exercise->file.empty()) work.exerciseFile = fs::absolute(exercise->file, ignored).string();
    }
    work.targetFile = targetFile;
    if (model.bur()) {
        work.bur = model.bur()->name;
        work.burFile = model.bur()->file.string();
    }
    work.seconds = model.log().seconds();
    work.events = model.log().events().all();
    return work;
}

void resumeWork(SessionTooth& tooth, const fs::path& folder, const std::vector<fs::path>& known) {
    SessionWork& work = tooth.work;
    if (!work.exercise.empty()) {
        if (auto exercise = exerciseOf(work, folder, known)) {
            tooth.name = exercise->name;
            setExercise(tooth, std::move(exercise));
        } else {
            tooth.importNotes.push_back({ImportNoteTopic::File, {msg::kNoteExerciseMissing, work.exercise}});
        }
    }
    if (work.targetFile.empty()) return;
    const fs::path target = found(work.targetFile, folder, known);
    if (target.empty()) {
        const std::string name = fs::path(work.targetFile).filename().string();
        tooth.importNotes.push_back({ImportNoteTopic::File, {msg::kNoteTargetMissing, name}});
    }
    work.targetFile = target.string();
}

Expected<SessionTooth> openSessionTooth(const ToothSource& source, const std::string& workOn,
                                        const std::vector<fs::path>& known, const ShareDone& progress) {
    Expected<SessionTooth> tooth = loadSessionTooth(source, workOn, progress);
    if (tooth) resumeWork(*tooth, source.outer.parent_path(), known);
    return tooth;
}

}  // namespace tactooth

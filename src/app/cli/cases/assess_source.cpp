// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_source.h"

#include "app/cli/cases/messages.h"
#include "app/cli/terminal/messages.h"
#include "app/common/report/preparation_parts.h"
#include "assessment/exercise_file.h"
#include "assessment/ideal_shape.h"
#include "assessment/rubric/exercise_rubric.h"
#include "geometry/files/file_bytes.h"
#include "session/cases/loaded_tooth.h"

namespace tactooth {

void addInputs(FileTransaction& files, const ComparisonOptions& options) {
    files.reads(options.expert);
    files.reads(options.original);
    for (const std::string& input : {options.exercise, options.rubric}) {  // or the name of a built-in one
        if (std::filesystem::path(input).has_extension()) files.reads(input);
    }
}

Expected<AssessSource> AssessSource::load(const ComparisonOptions& options) {
    if (options.expert.empty() && options.exercise.empty()) return unexpected(msg::kNothingToCompareWith);
    AssessSource source;
    if (!options.original.empty()) source.originalName_ = displayName(options.original);
    source.align_ = options.align;
    if (!options.exercise.empty()) {
        Expected<Exercise> found = findExercise(options.exercise);
        if (!found) return Unexpected{found.error()};
        source.exercise_ = std::move(*found);
    }
    Expected<Rubric> named = rubricOf(source.exercise_.value_or(Exercise{}), options.rubric);
    if (!named) return Unexpected{named.error()};
    source.rubric_ = std::move(*named);
    if (!options.original.empty()) {
        auto loaded = loadModelOrCase({.outer = options.original, .layers = {}}, {}, std::nullopt, 0.05);
        if (!loaded) return Unexpected{loaded.error()};
        source.notes_.insert(source.notes_.end(), loaded->importNotes.begin(), loaded->importNotes.end());
        source.uncut_ = loaded->piece->volume().tooth();
    } else if (source.exercise_) {
        auto tooth = exerciseTooth(*source.exercise_);
        if (!tooth) return Unexpected{tooth.error()};
        source.uncut_ = std::move(*tooth);
    }
    if (source.uncut_ != nullptr) source.original_ = source.uncut_->ownOuter();
    if (source.exercise_) {
        source.gums_ = exerciseGums(*source.exercise_);
        Expected<TriangleMesh> ideal = idealShape(*source.exercise_, source.uncut_);
        if (!ideal) return Unexpected{ideal.error()};
        source.ideal_ = std::make_shared<const SurfacePart>(std::move(*ideal));
    } else {
        Expected<GivenTooth> expert = loadGivenTooth(options.expert, msg::kExpertsTooth, source.notes_);
        if (!expert) return Unexpected{expert.error()};
        source.expert_ = std::move(*expert);
    }
    return source;
}

Expected<AssessedWork> AssessSource::workOf(const std::filesystem::path& file, std::vector<ImportNote>& notes) const {
    Expected<GivenTooth> student = loadGivenTooth(file, msg::kPreparedTooth, notes);
    if (!student) return Unexpected{student.error()};
    const std::shared_ptr<const LayeredTooth>& uncut = uncut_ != nullptr ? uncut_ : student->uncut;
    if (uncut == nullptr) return unexpected(msg::kNoUncutTooth, displayName(file));
    AssessedWork work;
    Preparation& preparation = work.preparation;
    preparation.original = original_ != nullptr ? original_ : uncut->ownOuter();
    preparation.mesialX = uncut->toothContext().mesialX;
    const std::string& original = originalName_.empty() ? student->name : originalName_;
    if (auto fits = checkSize(preparation.original->mesh(), original); !fits) return Unexpected{fits.error()};
    Pose studentInTooth;
    const auto fit = place(*student, studentInTooth, *preparation.original, align_);
    if (!fit) return Unexpected{fit.error()};
    if (student->uncut == nullptr) work.fit = *fit;
    if (exercise_) {
        preparation.ideal = ideal_;
        setExercise(work, *exercise_);
    } else {
        GivenTooth expert = *expert_;
        Pose expertInTooth;
        const auto lies = place(expert, expertInTooth, *preparation.original, align_);
        if (!lies) return Unexpected{lies.error()};
        work.expert = expert.name;
        work.expertTrack = expert.track;
        preparation.ideal = std::make_shared<const SurfacePart>(std::move(expert.surface));
    }
    preparation.prepared = std::make_shared<const SurfacePart>(std::move(student->surface));
    preparation.tooth = uncut;
    const bool isLayered = !uncut->layers().empty();
    if (!isLayered && student->uncut != nullptr && !align_) preparation.tooth = student->uncut;
    addPulps(preparation);
    if (student->cut != nullptr) addNeighbours(preparation, *student->uncut, *student->cut, studentInTooth);
    preparation.gums = gums_;
    const auto* plan = exercise_ ? std::get_if<PreparationPlan>(&exercise_->ideal) : nullptr;
    preparation.axis = plan != nullptr ? plan->outward : openingOf(preparation);
    work.student = student->name;
    work.track = student->track;
    work.sessionInTooth = studentInTooth;
    work.date = student->date;
    return work;
}

}  // namespace tactooth

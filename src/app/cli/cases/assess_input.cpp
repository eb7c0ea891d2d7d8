// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_input.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/cli/cases/messages.h"
#include "app/cli/terminal/messages.h"
#include "assessment/exercise_file.h"
#include "assessment/ideal_shape.h"
#include "collision/solid/solid_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/number_text.h"
#include "session/cases/loaded_tooth.h"
#include "session/track/make_track.h"

namespace tactooth {
namespace {

constexpr double kLargestTooth = 100;  // mm: with much of a jaw
constexpr double kSameTooth = 0.75;    // share of an uncut tooth that lies on itself; a fifth never counts
constexpr double kInPlace = 1e-3;      // mm: a surface that lies so well need not be moved

/// A tooth that somebody has worked on.
struct GivenTooth {
    std::string name;
    TriangleMesh surface = {};
    std::shared_ptr<const LayeredTooth> uncut = {};  ///< null: a plain surface
    std::shared_ptr<const Surface> cut = {};         ///< with the bodies around it; null: a plain surface
    std::shared_ptr<const SessionTrack> track = {};
    std::string date = {};  ///< empty: not known
};

Expected<void> checkSize(const TriangleMesh& mesh, const std::string& name) {
    const double size = boundingBox(mesh).sizes().maxCoeff();
    if (size <= kLargestTooth) return {};
    return unexpected(msg::kLargerThanATooth, name, numberText(std::round(size)));
}

Expected<GivenTooth> finished(GivenTooth work, const CutModel& piece) {
    work.cut = piece.surface();
    work.surface = asReadFromFile(*work.cut);
    work.uncut = piece.volume().tooth();
    if (auto fits = checkSize(work.surface, work.name); !fits) return Unexpected{fits.error()};
    return work;
}

Expected<GivenTooth> loadRecording(const std::filesystem::path& file) {
    const Expected<SessionRecording> recording = SessionRecording::open(file);
    if (!recording) return Unexpected{recording.error()};
    auto model = recording->makeModel();
    if (!model) return Unexpected{model.error()};
    auto track = emptyTrack(*recording, **model);
    if (!track) return Unexpected{track.error()};
    makeTrack(*recording, *model, **track);
    if (const auto fault = (*track)->fault()) return Unexpected{Error(*fault)};
    if (const auto at = (*track)->differsAt()) {
        return unexpected(msg::kReplayIsNotTheWork, displayName(file), fmt::format("{:.0f}", std::floor(*at)));
    }
    return finished({.name = displayFileName(file), .track = *track, .date = recording->facts().date}, **model);
}

Expected<GivenTooth> loadWork(const std::filesystem::path& file, const MessageText& what,
                              std::vector<ImportNote>& notes) {
    if (file.extension() == ".ttsession") return loadRecording(file);
    if (isToothFile(file)) {
        Expected<OpenedTooth> opened = openTooth(file);
        if (!opened) return Unexpected{opened.error()};
        notes.insert(notes.end(), opened->importNotes.begin(), opened->importNotes.end());
        return finished({.name = displayFileName(file)}, *opened->piece);
    }
    Expected<TriangleMesh> surface = loadSolid(file, what, {}, &notes);
    if (!surface) return Unexpected{surface.error()};
    if (auto fits = checkSize(*surface, displayName(file)); !fits) return Unexpected{fits.error()};
    return GivenTooth{.name = displayFileName(file), .surface = std::move(*surface)};
}

/// The uncut tooth, whatever the options say about it; null if they say nothing.
Expected<std::shared_ptr<const LayeredTooth>> uncutTooth(const AssessOptions& options, const GivenTooth& student,
                                                         const std::optional<Exercise>& exercise,
                                                         std::vector<ImportNote>& notes) {
    if (!options.original.empty()) {
        auto loaded = loadModelOrCase({.outer = options.original, .layers = {}}, {}, std::nullopt, 0.05);
        if (!loaded) return Unexpected{loaded.error()};
        notes.insert(notes.end(), loaded->importNotes.begin(), loaded->importNotes.end());
        return loaded->piece->volume().tooth();
    }
    if (exercise) return exerciseTooth(*exercise);
    if (student.uncut == nullptr) return unexpected(msg::kNoUncutTooth, displayName(options.student));
    return student.uncut;
}

/// Lays somebody's work on the uncut tooth, or checks that it lies there.
Expected<ScanFit> place(GivenTooth& work, Pose& pose, const SurfacePart& original, bool align) {
    const auto own = work.uncut != nullptr ? work.uncut->ownOuter() : nullptr;
    const TriangleMesh& reference = own != nullptr ? own->mesh() : work.surface;
    ScanFit fit = fitOf(reference, original);
    if (align && fit.residual > kInPlace) {
        const ScanAlignment alignment = alignScan(reference, original);
        pose = alignment.scanInTooth;
        fit = alignment.fit;
        work.surface = transformed(work.surface, pose);
    }
    const bool isSame = fit.isGood() && (own == nullptr || fit.usedShare >= kSameTooth);
    if (isSame) return fit;
    return unexpected(align ? msg::kNotAligned : msg::kNotInPlace, work.name, fmt::format("{:.3f}", fit.residual),
                      numberText(kMostResidual), fmt::format("{:.0f}", 100 * fit.usedShare));
}

/// The teeth beside, before the work and as far as it has cut them.
void addNeighbours(Preparation& preparation, const GivenTooth& work, const Pose& pose) {
    if (work.cut == nullptr) return;
    const MaterialRegistry& materials = work.uncut->materials();
    const auto adjacent = [&](const SurfacePart& part) {
        TriangleMesh mesh{part.mesh().vertices, {}};
        for (std::uint32_t i = part.firstAdjacent(); i < part.mesh().triangles.size(); ++i) {
            const auto material = static_cast<MaterialId>(part.tag(i));
            if (!materials.hasRole(material, MaterialRole::Surroundings))
                mesh.triangles.push_back(part.mesh().triangles[i]);
        }
        return transformed(mesh, pose);
    };
    TriangleMesh neighbours = adjacent(*work.uncut->outer());
    if (neighbours.empty()) return;
    preparation.neighbours = std::make_shared<const SurfacePart>(std::move(neighbours));
    for (const auto& patch : work.cut->patches) append(preparation.cutNeighbours, adjacent(*patch));
}

void addPulps(Preparation& preparation) {
    for (const LayeredTooth::Layer& layer : preparation.tooth->layers()) {
        if (preparation.tooth->materials().hasRole(layer.material, MaterialRole::Pulp))
            preparation.pulps.push_back(layer.part);
    }
}

/// The direction of the tooth that comes nearest to that into which the ideal preparation opens.
Vec3 openingOf(const Preparation& preparation) {
    const CavityWalls walls = cavityWalls(preparation.ideal->mesh(), *preparation.original);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < walls.mesh.triangles.size(); ++i) sum += walls.mesh.areaVector(i);
    int longest = 2;
    for (const int axis : {0, 1}) {
        if (std::abs(sum[axis]) > std::abs(sum[longest])) longest = axis;
    }
    return (sum[longest] < 0 ? -1.0 : 1.0) * Vec3::Unit(longest);
}

}  // namespace

Expected<AssessInput> loadAssessInput(const AssessOptions& options) {
    if (options.expert.empty() && options.exercise.empty()) return unexpected(msg::kNothingToCompareWith);
    AssessInput input;
    AssessedWork& work = input.work;
    std::optional<Exercise> exercise;
    if (!options.exercise.empty()) {
        Expected<Exercise> found = findExercise(options.exercise);
        if (!found) return Unexpected{found.error()};
        exercise = std::move(*found);
    }
    Expected<GivenTooth> student = loadWork(options.student, msg::kPreparedTooth, input.importNotes);
    if (!student) return Unexpected{student.error()};
    const auto uncut = uncutTooth(options, *student, exercise, input.importNotes);
    if (!uncut) return Unexpected{uncut.error()};
    Preparation& preparation = work.preparation;
    preparation.original = (*uncut)->ownOuter();
    preparation.mesialX = (*uncut)->toothContext().mesialX;
    if (auto fits = checkSize(preparation.original->mesh(), displayName(options.original)); !fits)
        return Unexpected{fits.error()};
    Pose studentInTooth, expertInTooth;
    const auto fit = place(*student, studentInTooth, *preparation.original, options.align);
    if (!fit) return Unexpected{fit.error()};
    if (student->uncut == nullptr) work.fit = *fit;
    Expected<TriangleMesh> ideal = TriangleMesh{};
    if (exercise) {
        ideal = idealShape(*exercise, *uncut);
        if (!ideal) return Unexpected{ideal.error()};
        work.expert = exercise->name;
        work.task = exercise->task;
        work.tolerance = exercise->tolerance;
    } else {
        Expected<GivenTooth> expert = loadWork(options.expert, msg::kExpertsTooth, input.importNotes);
        if (!expert) return Unexpected{expert.error()};
        const auto lies = place(*expert, expertInTooth, *preparation.original, options.align);
        if (!lies) return Unexpected{lies.error()};
        work.expert = expert->name;
        ideal = std::move(expert->surface);
    }
    preparation.ideal = std::make_shared<const SurfacePart>(std::move(*ideal));
    preparation.prepared = std::make_shared<const SurfacePart>(std::move(student->surface));
    preparation.tooth = *uncut;
    const bool isLayered = !(*uncut)->layers().empty();
    if (!isLayered && student->uncut != nullptr && !options.align) preparation.tooth = student->uncut;
    addPulps(preparation);
    addNeighbours(preparation, *student, studentInTooth);
    const auto* plan = exercise ? std::get_if<PreparationPlan>(&exercise->ideal) : nullptr;
    preparation.axis = plan != nullptr ? plan->outward : openingOf(preparation);
    work.student = student->name;
    work.track = student->track;
    work.date = student->date;
    return input;
}

}  // namespace tactooth

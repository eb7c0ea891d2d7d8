// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/draft_ideal.h"

#include <utility>

#include "app/gui/editor/messages.h"

namespace tactooth {
namespace {

constexpr double kShaped = 0.7;  // about this share of the time

/// Fails with one sentence. A cavity without a ghost where `progress` has ended the work.
Expected<IdealCavity> makeIdeal(const Exercise& exercise, const std::shared_ptr<const LayeredTooth>& tooth,
                                const IdealProgress& progress) {
    const auto shaping = [&](double share) { return progress(kShaped * share); };
    const Expected<TriangleMesh> shape = idealShape(exercise, tooth, shaping);
    if (!shape) return unexpected(msg::kDraftNoIdeal, shape.error());
    if (!progress(kShaped)) return IdealCavity{};
    const std::shared_ptr<const SurfacePart> outer = tooth->ownOuter();
    CavityWalls walls = cavityWalls(*shape, *outer);
    if (walls.mesh.empty()) return unexpected(msg::kDraftIdealEmpty);
    const std::optional<double> toPulp = leastToPulp(walls, *tooth);
    return IdealCavity{std::make_shared<CavityGhost>(std::move(walls), *outer), toPulp};
}

}  // namespace

void DraftIdeal::follow(const Exercise& exercise, const std::shared_ptr<const LayeredTooth>& tooth) {
    if (isOf(exercise, tooth)) return;
    clear();
    source_ = {exercise.ideal, exercise.bur, tooth};
    work_ = std::make_shared<Work>();
    Exercise unnamed = exercise;
    unnamed.file.clear();  // the sentence is about the draft
    task_.start([exercise = std::move(unnamed), tooth, work = work_] {
        return makeIdeal(exercise, tooth, [&](double share) {
            work->share = share;
            return work->isWanted.load();
        });
    });
}

bool DraftIdeal::isOf(const Exercise& exercise, const std::shared_ptr<const LayeredTooth>& tooth) const {
    return source_ == Source{exercise.ideal, exercise.bur, tooth};
}

void DraftIdeal::clear() {
    if (work_ != nullptr) work_->isWanted = false;
    task_.cancel();
    source_.reset();
    cavity_.reset();
    fault_.reset();
    work_.reset();
}

bool DraftIdeal::poll() {
    auto made = task_.poll();
    if (!made) return false;
    if (*made) {
        cavity_ = std::move(**made);
    } else {
        fault_ = made->error();
    }
    return true;
}

}  // namespace tactooth

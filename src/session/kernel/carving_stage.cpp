// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/kernel/carving_stage.h"

#include <bit>
#include <utility>

#include "geometry/util/assert.h"
#include "haptics/tip/tip_hold.h"

namespace tactooth {
namespace {

constexpr double kPauseBetweenCuts = 0.4;  // s without contact: the bur was lifted, a new cut begins (mark for undo)

// A blade that is drawn along takes a chip; a turning edge grinds. 1 N along 1 mm takes 0.08 mm^3 of infected dentin
// (Knoop 15, 150 N/mm^2: a chip needs some tenth of the hardness as work for each volume), and the table says what a
// rim grinds. The softness of infected dentin is a half.
constexpr double kBladePerRim = 1400;

/// What a blade in the hand takes: of soft decay the more the softer it is, of sound tissue nothing.
MaterialTable handMaterials(MaterialTable materials) {
    for (const MaterialId id : materials.registry().ids()) {
        materials[id].removal *= kBladePerRim * softness(materials, id);
    }
    return materials;
}

}  // namespace

CarvingStage::CarvingStage(std::shared_ptr<CutModel> model, const Instrument& instrument, MaterialTable materials)
    : model_(std::move(model)),
      tool_(instrument.cutting),
      scrapes_(instrument.scrapes()),
      materials_(scrapes_ ? handMaterials(std::move(materials)) : std::move(materials)) {
    TACTOOTH_ASSERT(model_ != nullptr);
}

bool CarvingStage::cutsAt(const Tick& tick) const {
    return tick.contact.triangles > 0 && (scrapes_ || (tick.input.cutting && tick.spindle.speedRpm > 0));
}

/// Returns `changed`. A turn that changes nothing is in the hash by its place among the others.
bool CarvingStage::addToHash(bool changed) {
    const auto add = [this](double value) { hash_.addWord(std::bit_cast<std::uint64_t>(value)); };
    hash_.addWord(changed ? 1 : 0);
    if (!changed) return false;
    for (const double volume : model_->loss().removed) add(volume);
    add(model_->loss().beside);
    hash_.addWord(model_->loss().pieces);
    if (model_->reached()) {
        for (int axis = 0; axis < 3; ++axis) add(model_->reached()->position[axis]);
        for (int i = 0; i < 4; ++i) add(model_->reached()->rotation.coeffs()[i]);
    }
    return true;
}

bool CarvingStage::carve(const Tick& tick) {
    time_ = tick.time;
    if (tick.input.cutting || scrapes_) {
        const bool cuts = cutsAt(tick);
        if (cuts && tick.time > lastCut_ + kPauseBetweenCuts) model_->mark(tick.time);
        if (cuts) lastCut_ = tick.time;
        const bool changed = scrapes_ ? model_->scrape(tool_, tick, materials_) : model_->feed(tool_, tick, materials_);
        if (changed) return addToHash(true);
    }
    return addToHash(model_->removeDetachedPieces(tick));
}

bool CarvingStage::edit(Edit edit) {
    lastCut_ = -std::numeric_limits<double>::infinity();  // the next cut is a step of its own
    switch (edit) {
        case Edit::Reset:
            return addToHash(model_->reset(time_));
        case Edit::Undo:
            return addToHash(model_->undo());
        case Edit::Redo:
            return addToHash(model_->redo());
    }
    TACTOOTH_ASSERT(false);
    return false;
}

bool CarvingStage::finish(bool dropsPieces) {
    if (dropsPieces) return addToHash(model_->removeDetachedPieces());
    const std::uint64_t before = model_->surface()->revision;
    model_->refreshSurface();
    return addToHash(model_->surface()->revision != before);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/cavity_fields.h"

#include <algorithm>

#include "assessment/exercise_keys.h"

namespace tactooth {
namespace {

constexpr ProximalBox kUsualBox = {.towardX = 1, .width = 3, .axialDepth = 1.4, .axialHeight = 1.2};
constexpr std::array<double ProximalBox::*, 3> kBoxMeasures = {&ProximalBox::width, &ProximalBox::axialDepth,
                                                               &ProximalBox::axialHeight};

void changePlan(Exercise& exercise, const std::function<void(PreparationPlan&)>& change) {
    if (auto* plan = std::get_if<PreparationPlan>(&exercise.ideal)) change(*plan);
}

/// Boxes end a cavity from the occlusal side with a flat floor.
bool mayHaveBoxes(const PreparationPlan& plan) { return plan.outline && plan.isFlat && plan.outward == Vec3::UnitZ(); }

double towardOf(const Exercise& exercise, std::size_t side) {
    return (side == 0 ? 1 : -1) * toothMesialX(exercise.tooth);
}

Lesion* lesionOf(Exercise& exercise) {
    auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    return request != nullptr && request->lesion ? &*request->lesion : nullptr;
}

}  // namespace

CavityFields::CavityFields() : DraftFields(tr("Cavity")), hasDecay_(new QCheckBox(tr("Decay"))) {
    const QStringList sides = {tr("Occlusal"), tr("Buccal"), tr("Lingual"), tr("Mesial"), tr("Distal")};
    side_ = addChoice("editSide", tr("Seen from"), sides, [](Exercise& exercise, int entry) {
        const auto outward = sideKeys(toothMesialX(exercise.tooth)).at(static_cast<std::size_t>(entry)).second;
        changePlan(exercise, [&](PreparationPlan& plan) {
            plan.outward = outward;
            if (!mayHaveBoxes(plan)) plan.boxes.clear();
        });
    });
    depth_ = addNumber("editDepth", tr("Depth"), {kMinDepth, kMaxDepth, 0.1, 2, tr(" mm")},
                       [](Exercise& exercise, double value) {
                           changePlan(exercise, [&](PreparationPlan& plan) { plan.depth = value; });
                       });
    taper_ = addNumber("editTaper", tr("Taper of the walls"), {0, kMostTaper, 1, 1, tr("°")},
                       [](Exercise& exercise, double value) {
                           changePlan(exercise, [&](PreparationPlan& plan) {
                               if (plan.outline) plan.outline->taperDegrees = value;
                           });
                       });
    taper_->setToolTip(tr("How much the walls lean outward; 0: as the bur makes them"));
    floor_ =
        addChoice("editFloor", tr("Floor"), {tr("Flat"), tr("Follows the surface")}, [](Exercise& exercise, int entry) {
            changePlan(exercise, [&](PreparationPlan& plan) {
                plan.isFlat = entry == 0;
                if (!mayHaveBoxes(plan)) plan.boxes.clear();
            });
        });
    addBox(0, tr("Mesial box"), "Mesial");
    addBox(1, tr("Distal box"), "Distal");
    addDecay();
}

void CavityFields::addBox(std::size_t side, const QString& title, const char* name) {
    BoxFields& fields = boxes_[side];
    fields.has = new QCheckBox(title);
    fields.has->setObjectName(QString("edit%1Box").arg(name));
    form().addRow(fields.has);
    connect(fields.has, &QCheckBox::toggled, this, [this, side](bool on) {
        ask({}, [side, on](Exercise& exercise) {
            const double toward = towardOf(exercise, side);
            changePlan(exercise, [&](PreparationPlan& plan) {
                std::erase_if(plan.boxes, [&](const ProximalBox& box) { return box.towardX == toward; });
                if (!on) return;
                plan.boxes.push_back(kUsualBox);
                plan.boxes.back().towardX = toward;
            });
        });
    });
    const std::array<QString, 3> labels = {tr("Width"), tr("Axial depth"), tr("Axial height")};
    constexpr std::array kNames = {"Width", "AxialDepth", "AxialHeight"};
    for (std::size_t i = 0; i < kBoxMeasures.size(); ++i) {
        const QByteArray id = QString("edit%1%2").arg(name, kNames[i]).toLatin1();
        fields.measures[i] = addNumber(id, labels[i], {kMinDepth, kMaxBox, 0.1, 2, tr(" mm")},
                                       [side, i](Exercise& exercise, double value) {
                                           const double toward = towardOf(exercise, side);
                                           changePlan(exercise, [&](PreparationPlan& plan) {
                                               for (ProximalBox& box : plan.boxes) {
                                                   if (box.towardX == toward) box.*kBoxMeasures[i] = value;
                                               }
                                           });
                                       });
    }
}

void CavityFields::addDecay() {
    hasDecay_->setObjectName("editHasDecay");
    hasDecay_->setToolTip(tr("Choose Decay above, and click or drag over the tooth"));
    form().addRow(hasDecay_);
    connect(hasDecay_, &QCheckBox::toggled, this, [this](bool on) {
        ask({}, [on](Exercise& exercise) {
            auto* request = std::get_if<ToothRequest>(&exercise.tooth);
            if (request != nullptr) request->lesion = on ? std::optional(Lesion{}) : std::nullopt;
        });
    });
    decayWidth_ = addNumber("editDecayWidth", tr("Width"), {kMinLesionWidth, kMaxLesionWidth, 0.2, 1, tr(" mm")},
                            [](Exercise& exercise, double value) {
                                if (Lesion* lesion = lesionOf(exercise)) lesion->width = value;
                            });
    // Below the least depth: the one that fits the width.
    decayDepth_ = addNumber("editDecayDepth", tr("Depth"), {kMinLesionDepth - 0.1, kDeepestLesion, 0.1, 1, tr(" mm")},
                            [](Exercise& exercise, double value) {
                                Lesion* lesion = lesionOf(exercise);
                                if (lesion == nullptr) return;
                                lesion->depth.reset();
                                if (value >= kMinLesionDepth - 1e-9) lesion->depth = value;
                            });
    decayDepth_->setSpecialValueText(tr("fits the width"));
    // Below the least width: none.
    rimWidth_ = addNumber("editRimWidth", tr("Affected dentin"), {0, kMaxRimWidth, kMinRimWidth, 1, tr(" mm")}, setRim);
    rimWidth_->setSpecialValueText(tr("none"));
    rimWidth_->setToolTip(tr("Leathery dentin around the decay: harder than the decay, softer than sound dentin"));
}

void CavityFields::showBox(const BoxFields& fields, const ExerciseDraft& draft, double towardX) const {
    const PreparationPlan* plan = draft.plan();
    const bool may = plan != nullptr && mayHaveBoxes(*plan);
    const ProximalBox* shown = nullptr;
    for (std::size_t i = 0; plan != nullptr && i < plan->boxes.size(); ++i) {
        if (plan->boxes[i].towardX == towardX) shown = &plan->boxes[i];
    }
    fields.has->setEnabled(may);
    fields.has->setChecked(shown != nullptr);
    for (std::size_t i = 0; i < kBoxMeasures.size(); ++i) {
        form().setRowVisible(fields.measures[i], shown != nullptr);
        if (shown != nullptr) fields.measures[i]->setValue(shown->*kBoxMeasures[i]);
    }
}

void CavityFields::showDraft(const ExerciseDraft& draft) {
    const PreparationPlan* plan = draft.plan();
    for (QWidget* field : {static_cast<QWidget*>(side_), static_cast<QWidget*>(depth_), static_cast<QWidget*>(floor_)})
        field->setEnabled(plan != nullptr);
    taper_->setEnabled(plan != nullptr && plan->outline.has_value());
    if (plan != nullptr) {
        const auto sides = sideKeys(toothMesialX(draft.exercise().tooth));
        const auto known = std::ranges::find(sides, plan->outward, [](const auto& side) { return side.second; });
        side_->setCurrentIndex(known != sides.end() ? static_cast<int>(known - sides.begin()) : -1);
        depth_->setValue(plan->depth);
        taper_->setValue(plan->outline ? plan->outline->taperDegrees : 0);
        floor_->setCurrentIndex(plan->isFlat ? 0 : 1);
    }
    for (std::size_t side = 0; side < boxes_.size(); ++side)
        showBox(boxes_[side], draft, towardOf(draft.exercise(), side));
    const auto* request = std::get_if<ToothRequest>(&draft.exercise().tooth);
    const Lesion* lesion = request != nullptr && request->lesion ? &*request->lesion : nullptr;
    hasDecay_->setEnabled(request != nullptr);
    hasDecay_->setChecked(lesion != nullptr);
    form().setRowVisible(decayWidth_, lesion != nullptr);
    form().setRowVisible(decayDepth_, lesion != nullptr);
    form().setRowVisible(rimWidth_, mayHaveRim(draft.exercise()));
    if (lesion == nullptr) return;
    decayWidth_->setValue(lesion->width);
    decayDepth_->setValue(lesion->depth.value_or(decayDepth_->minimum()));
    rimWidth_->setValue(lesion->rim ? lesion->rim->width : 0);
}

}  // namespace tactooth

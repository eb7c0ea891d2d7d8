// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/tooth_fields.h"

#include <QGridLayout>
#include <QRadioButton>

#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

std::vector<int> permanentTeeth() {
    std::vector<int> teeth;
    for (int fdi = 11; fdi <= 48; ++fdi) {
        if (isPermanentTooth(fdi)) teeth.push_back(fdi);
    }
    return teeth;
}

/// What is drawn on one tooth fits no other.
void takeTooth(Exercise& exercise, int fdi) {
    auto* request = std::get_if<ToothRequest>(&exercise.tooth);
    if (request == nullptr || request->fdi == fdi) return;
    request->fdi = fdi;
    if (request->lesion) request->lesion->place.reset();
    exercise.forbidden.clear();
    if (auto* plan = std::get_if<PreparationPlan>(&exercise.ideal)) {
        if (plan->outline) plan->outline->corners.clear();
        plan->boxes.clear();
    }
}

}  // namespace

ToothFields::ToothFields()
    : DraftFields(tr("Tooth and drawing")),
      inMouth_(new QCheckBox(tr("In the mouth, with its neighbours"))),
      strokes_(new QButtonGroup(this)),
      removeZone_(new QPushButton(tr("Remove zone"))) {
    QStringList teeth;
    for (const int fdi : permanentTeeth())
        teeth << QString("%1  %2").arg(fdi).arg(translated(std::string_view(toothName(fdi))));
    tooth_ = addChoice("editTooth", tr("Tooth"), teeth, [](Exercise& exercise, int entry) {
        takeTooth(exercise, permanentTeeth().at(static_cast<std::size_t>(entry)));
    });
    inMouth_->setObjectName("editInMouth");
    form().addRow(inMouth_);
    connect(inMouth_, &QCheckBox::toggled, this, [this](bool on) {
        ask({}, [on](Exercise& exercise) {
            exercise.inMouth = on;
            if (auto* request = std::get_if<ToothRequest>(&exercise.tooth); request != nullptr && on) request->seed = 0;
        });
    });
    addTemplates();
    addStrokes();
}

void ToothFields::addTemplates() {
    const std::array<std::pair<QString, const char*>, 4> titles = {{{tr("Class I"), "templateClassOne"},
                                                                    {tr("Class II, mesial"), "templateClassTwoMesial"},
                                                                    {tr("Class II, distal"), "templateClassTwoDistal"},
                                                                    {tr("Class V"), "templateClassFive"}}};
    auto* grid = new QGridLayout;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        templates_[i] = new QPushButton(titles[i].first);
        templates_[i]->setObjectName(titles[i].second);
        templates_[i]->setToolTip(
            tr("Draws the outline of such a cavity on the tooth, in place of the one that is there"));
        const auto place = static_cast<int>(i);
        grid->addWidget(templates_[i], place / 2, place % 2);
        connect(templates_[i], &QPushButton::clicked, this,
                [this, kind = static_cast<ExerciseTemplate>(i)] { emit templateWanted(kind); });
    }
    auto* free = new QPushButton(tr("Free outline"));
    free->setObjectName("freeOutline");
    free->setToolTip(tr("Takes the outline away: draw it point by point"));
    connect(free, &QPushButton::clicked, this, &ToothFields::freeOutlineWanted);
    grid->addWidget(free, 2, 0);
    form().addRow(tr("Begin with"), grid);
}

void ToothFields::addStrokes() {
    auto* grid = new QGridLayout;
    const std::array<std::pair<QString, const char*>, 3> titles = {
        {{tr("Outline"), "drawOutline"}, {tr("Forbidden zone"), "drawZone"}, {tr("Decay"), "drawDecay"}}};
    for (std::size_t i = 0; i < titles.size(); ++i) {
        auto* button = new QRadioButton(titles[i].first);
        button->setObjectName(titles[i].second);
        strokes_->addButton(button, static_cast<int>(i));
        grid->addWidget(button, static_cast<int>(i), 0);
    }
    connect(strokes_, &QButtonGroup::idClicked, this,
            [this](int id) { emit strokeChosen(static_cast<DraftStroke>(id)); });
    auto* add = new QPushButton(tr("New zone"));
    add->setObjectName("newZone");
    connect(add, &QPushButton::clicked, this, &ToothFields::newZoneWanted);
    removeZone_->setObjectName("removeZone");
    connect(removeZone_, &QPushButton::clicked, this, &ToothFields::zoneRemovalWanted);
    grid->addWidget(add, 0, 1);
    grid->addWidget(removeZone_, 1, 1);
    form().addRow(tr("A click draws"), grid);
}

void ToothFields::showStroke(DraftStroke stroke, bool hasZone) {
    strokes_->button(static_cast<int>(stroke))->setChecked(true);
    removeZone_->setEnabled(hasZone);
}

void ToothFields::showDraft(const ExerciseDraft& draft) {
    const auto* request = std::get_if<ToothRequest>(&draft.exercise().tooth);
    tooth_->setEnabled(request != nullptr);
    inMouth_->setEnabled(request != nullptr);
    inMouth_->setChecked(draft.exercise().inMouth);
    strokes_->button(static_cast<int>(DraftStroke::Decay))->setEnabled(request != nullptr);
    if (request != nullptr) {
        const std::vector<int> teeth = permanentTeeth();
        tooth_->setCurrentIndex(static_cast<int>(std::ranges::find(teeth, request->fdi) - teeth.begin()));
    }
    for (std::size_t i = 0; i < templates_.size(); ++i)
        templates_[i]->setEnabled(fits(static_cast<ExerciseTemplate>(i), draft.exercise()));
}

}  // namespace tactooth

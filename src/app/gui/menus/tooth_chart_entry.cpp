// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/tooth_chart_entry.h"

#include <QAction>
#include <array>
#include <utility>

#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/dialogs/tooth_chart_dialog.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/model/exercise_tooth.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr std::array<std::pair<ToothNotation, const char*>, 3> kWords = {
    {{ToothNotation::Fdi, "fdi"}, {ToothNotation::Universal, "universal"}, {ToothNotation::Palmer, "palmer"}}};

}  // namespace

ToothChartEntry::ToothChartEntry(QWidget& window, SessionModel& model, ToothController& teeth,
                                 ExerciseController& exercise)
    : window_(window),
      model_(model),
      teeth_(teeth),
      exercise_(exercise),
      action_(new QAction(tr("&Tooth chart…"), &window)) {
    action_->setObjectName("toothChartEntry");
    bindKey(*action_, KeyId::Chart, tr("Chooses a tooth of the whole mouth, with its neighbours and gums (%1)"));
    action_->setStatusTip(tr("Chooses a tooth of the whole mouth, with its neighbours and gums"));
    setLineIcon(*action_, "mouth");
    connect(action_, &QAction::triggered, this, &ToothChartEntry::open);
    showTooth();
}

void ToothChartEntry::showTooth() {
    const int fdi = model_.tooth() ? fdiOf(*model_.tooth()) : 0;
    action_->setIconText(fdi == 0 ? tr("Tooth chart")
                                  : tr("Tooth %1").arg(QString::fromStdString(toothLabel(fdi, notation_))));
}

void ToothChartEntry::open() {
    ToothChartMarks marks;
    if (model_.tooth()) marks.loaded = fdiOf(*model_.tooth());
    for (const auto& exercise : exercise_.known()) {
        const int fdi = exercise != nullptr ? fdiOf(*exercise) : 0;
        if (fdi != 0) marks.exercises[fdi] << exerciseTitle(*exercise);
    }
    auto* chart = new ToothChartDialog(marks, notation_, &window_);
    connect(chart, &ToothChartDialog::chosen, this, [this](int fdi) { teeth_.loadMouth({.fdi = fdi}); });
    connect(chart, &ToothChartDialog::notationChosen, this, [this](ToothNotation notation) {
        notation_ = notation;
        showTooth();
    });
    chart->open();
}

void ToothChartEntry::restore(const WindowSettings& settings) {
    notation_ = ToothNotation::Fdi;
    for (const auto& [notation, word] : kWords) {
        if (settings.notation == word) notation_ = notation;
    }
    showTooth();
}

void ToothChartEntry::store(WindowSettings& settings) const {
    for (const auto& [notation, word] : kWords) {
        if (notation == notation_) settings.notation = word;
    }
}

}  // namespace tactooth

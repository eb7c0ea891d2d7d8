// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/bur_entry.h"

#include <QAction>

#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/dialogs/bur_dialog.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/panels/drill_bar.h"
#include "assessment/allowed_instruments.h"

namespace tactooth {

BurEntry::BurEntry(QWidget& window, DrillBar& drill, const ExerciseController& exercise)
    : window_(window), drill_(drill), exercise_(exercise), action_(new QAction(tr("&Burs…"), &window)) {
    action_->setObjectName("burEntry");
    bindKey(*action_, KeyId::Burs);
    action_->setStatusTip(tr("Chooses a bur by its picture"));
    setLineIcon(*action_, "bur");
    connect(action_, &QAction::triggered, this, &BurEntry::open);
    connect(&drill_, &DrillBar::gridWanted, this, &BurEntry::open);
}

void BurEntry::open() {
    if (!drill_.isEnabled()) return;  // a recording is shown
    const auto& exercise = exercise_.active();
    auto* grid = new BurGrid(drill_.burs(), favourites_,
                             exercise != nullptr ? bursOf(*exercise) : std::set<std::string>(), pictures_);
    grid->select(drill_.currentBur());
    connect(grid, &BurGrid::favouritesChanged, this,
            [this](const std::set<std::string>& favourites) { favourites_ = favourites; });
    auto* dialog = new BurDialog(grid, &window_);
    connect(grid, &BurGrid::taken, &drill_, &DrillBar::takeBur);
    dialog->open();
}

void BurEntry::restore(const WindowSettings& settings) { favourites_ = burNumbers(settings.favouriteBurs); }

void BurEntry::store(WindowSettings& settings) const { settings.favouriteBurs = asText(favourites_); }

}  // namespace tactooth

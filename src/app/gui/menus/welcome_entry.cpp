// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/welcome_entry.h"

#include <QAction>

#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/manual_controller.h"
#include "app/gui/controllers/recording_controller.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/dialogs/welcome_dialog.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/menus/appearance_menu.h"
#include "app/gui/menus/file_menu.h"

namespace tactooth {

WelcomeEntry::WelcomeEntry(const Parts& parts) : parts_(parts), action_(new QAction(tr("&Welcome…"), &parts.window)) {
    action_->setObjectName("welcomeEntry");
    action_->setStatusTip(tr("Exercises, recent work, the manual and the language"));
    bindKey(*action_, KeyId::Welcome);
    setLineIcon(*action_, "welcome");
    connect(action_, &QAction::triggered, this, &WelcomeEntry::open);
}

bool WelcomeEntry::isOpen() const { return page_ != nullptr; }

void WelcomeEntry::open() {
    if (page_ != nullptr) return page_->raise();
    constexpr int kMost = 8;  // of files, and as many recordings
    WelcomeDialog::Contents contents;
    const auto kept =
        parts_.recordings.hasFolder() ? parts_.recordings.folder().finished() : std::vector<std::filesystem::path>();
    contents.recent = recentWork(parts_.files.recent(), kept, kMost);
    contents.exercises = parts_.exercise.known();
    contents.language = parts_.appearance.language();
    contents.comesAtStart = comesAtStart_;
    page_ = new WelcomeDialog(std::move(contents), &parts_.window);
    connect(page_, &WelcomeDialog::toothRequested, &parts_.teeth, &ToothController::askForScan);
    connect(page_, &WelcomeDialog::demonstrationRequested, &parts_.tour, &GuidedTour::start);
    connect(page_, &WelcomeDialog::manualRequested, &parts_.manual, &ManualController::openForFocus);
    connect(page_, &WelcomeDialog::exerciseChosen, &parts_.exercise, &ExerciseController::start);
    connect(page_, &WelcomeDialog::fileChosen, &parts_.teeth, &ToothController::openFile);
    connect(page_, &WelcomeDialog::languageChosen, &parts_.appearance, &AppearanceMenu::chooseLanguage);
    connect(page_, &WelcomeDialog::comesAtStartChanged, this, [this](bool comes) { comesAtStart_ = comes; });
    page_->addAction(&parts_.files.quit());  // the menus do not hear keys while the page is open
    page_->open();
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/window_menus.h"

#include <QDockWidget>
#include <QMenuBar>

#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/instrument_tray.h"
#include "app/gui/panels/sound_panel.h"
#include "session/model/session_model.h"

namespace tactooth {

WindowMenus::WindowMenus(QMainWindow& window, const DockLayout& docks, const WindowPanels& panels, SessionModel& model,
                         ToothController& teeth, ExerciseController& exercise, RecordingController& recordings,
                         ExaminationController& examinations, WindowMessages& messages, const KeyController& keys,
                         ManualController& manual)
    : model_(model),
      file_(window, docks.fileBar(), model, teeth, exercise, recordings, examinations),
      burs_(window, *panels.drill, exercise),
      instruments_(model.instruments()) {
    addViewMenu(window, docks.viewBar(), panels);
    addDrillMenu(*window.menuBar(), panels);
    welcome_ = std::make_unique<WelcomeEntry>(
        WelcomeEntry::Parts{window, teeth, exercise, recordings, file_, *appearance_, manual, *panels.tour});
    exercise_ = std::make_unique<ExerciseMenu>(*window.menuBar(), welcome_->action(), exercise, *panels.exercise);
    addSoundMenu(*window.menuBar(), *panels.sound);
    help_ = std::make_unique<HelpMenu>(*window.menuBar(), window, *welcome_, *panels.tour, messages, keys, manual);
}

void WindowMenus::addViewMenu(QMainWindow& window, QToolBar& bar, const WindowPanels& panels) {
    QMenu* menu = viewMenu_ = window.menuBar()->addMenu(tr("&View"));
    view_ = std::make_unique<ViewMenu>(*menu, bar, *panels.view);
    aids_ = std::make_unique<ViewAidsMenu>(*menu, *panels.view);
    measure_ = std::make_unique<MeasureMenu>(*menu, *panels.view);
    instruments_.addMirrorMenu(*menu);
    menu->addAction(panels.inspection->ghostAction());
    replayPlace_ = menu->addSeparator();
    appearance_ = std::make_unique<AppearanceMenu>(*menu);
    menu->addSeparator();
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        setLineIcon(*dock->toggleViewAction(), "panel");
        menu->addAction(dock->toggleViewAction());
    }
    QAction* reset = menu->addAction(tr("Reset la&yout"), this, &WindowMenus::layoutResetWanted);
    reset->setObjectName("resetLayout");
    setLineIcon(*reset, "reset-layout");
}

void WindowMenus::addReplayEntry(QAction& entry) { viewMenu_->insertAction(replayPlace_, &entry); }

void WindowMenus::addDrillMenu(QMenuBar& bar, const WindowPanels& panels) {
    QMenu* menu = bar.addMenu(tr("&Drill"));
    menu->addAction(&burs_.action());
    // Not the first entry: there the right arrow, of keys or gamepad, would open it in place of the next menu.
    QMenu* instruments = menu->addMenu(tr("&Instruments"));
    instruments->setObjectName("instruments");
    setLineIcon(*instruments->menuAction(), "handpiece");
    instruments->addActions(panels.tray->actions());
    menu->addSeparator();
    menu->addActions({panels.drill->touchAction(), panels.drill->cutAction(), panels.device->clutchAction()});
    menu->addSeparator();
    const auto add = [&](const QString& text, KeyId key, const char* icon, const auto& act) {
        QAction* action = menu->addAction(text, this, act);
        bindKey(*action, key);
        setLineIcon(*action, icon);
    };
    constexpr double kTurn = 0.2;  // rad for one press of the key
    add(tr("Stand the bur &upright"), KeyId::Upright, "upright", [this] { model_.manipulator().resetOrientation(); });
    add(tr("Turn the handle &left"), KeyId::TurnHandleLeft, "turn-left",
        [this] { model_.manipulator().rotateHandle(kTurn); });
    add(tr("Turn the handle &right"), KeyId::TurnHandleRight, "turn-right",
        [this] { model_.manipulator().rotateHandle(-kTurn); });
    menu->addSeparator();
    instruments_.addSpraySwitches(*menu);
    menu->addSeparator();
    menu->addActions({panels.drill->undoAction(), panels.drill->redoAction(), panels.drill->resetAction()});
}

void WindowMenus::addSoundMenu(QMenuBar& bar, SoundPanel& panel) {
    QAction* mute = bar.addMenu(tr("&Sound"))->addAction(tr("&Mute"));
    mute->setCheckable(true);
    setLineIcon(*mute, "mute");
    bindKey(*mute, KeyId::Mute);
    connect(mute, &QAction::toggled, &panel, &SoundPanel::setMuted);
    connect(&panel, &SoundPanel::mutedChanged, mute, &QAction::setChecked);
}

void WindowMenus::restore(const WindowSettings& settings) {
    view_->restore(settings);
    aids_->restore(settings);
    appearance_->restore(settings);
    file_.restore(settings);
    burs_.restore(settings);
    instruments_.restore(settings);
    welcome_->restore(settings);
}

void WindowMenus::store(WindowSettings& settings) const {
    view_->store(settings);
    aids_->store(settings);
    appearance_->store(settings);
    file_.store(settings);
    burs_.store(settings);
    instruments_.store(settings);
    welcome_->store(settings);
}

}  // namespace tactooth

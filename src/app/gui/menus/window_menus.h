// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/gui/controllers/dock_layout.h"
#include "app/gui/menus/appearance_menu.h"
#include "app/gui/menus/bur_entry.h"
#include "app/gui/menus/exercise_menu.h"
#include "app/gui/menus/file_menu.h"
#include "app/gui/menus/help_menu.h"
#include "app/gui/menus/instrument_menus.h"
#include "app/gui/menus/measure_menu.h"
#include "app/gui/menus/view_aids_menu.h"
#include "app/gui/menus/view_menu.h"
#include "app/gui/menus/welcome_entry.h"

namespace tactooth {

/// The menu bar of the window: files, view, drill, exercises, sound and help.
class WindowMenus final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the menus.
    WindowMenus(QMainWindow& window, const DockLayout& docks, const WindowPanels& panels, SessionModel& model,
                ToothController& teeth, ExerciseController& exercise, RecordingController& recordings,
                ExaminationController& examinations, WindowMessages& messages, const KeyController& keys,
                ManualController& manual);

    [[nodiscard]] FileMenu& file() { return file_; }
    [[nodiscard]] AppearanceMenu& appearance() const { return *appearance_; }
    [[nodiscard]] InstrumentMenus& instruments() { return instruments_; }
    [[nodiscard]] ExerciseMenu& exercise() const { return *exercise_; }
    [[nodiscard]] WelcomeEntry& welcome() const { return *welcome_; }

    /// An entry of the replay, in the menu View.
    void addReplayEntry(QAction& entry);

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

signals:
    /// Docks, tool bars and size of the window should be as at the first start.
    void layoutResetWanted();

private:
    void addViewMenu(QMainWindow& window, QToolBar& bar, const WindowPanels& panels);
    void addDrillMenu(QMenuBar& bar, const WindowPanels& panels);
    void addSoundMenu(QMenuBar& bar, SoundPanel& panel);

    SessionModel& model_;
    QMenu* viewMenu_ = nullptr;
    QAction* replayPlace_ = nullptr;  // the entry of the menu View that those of the replay stand before
    FileMenu file_;
    BurEntry burs_;
    InstrumentMenus instruments_;
    std::unique_ptr<ViewMenu> view_;
    std::unique_ptr<ViewAidsMenu> aids_;
    std::unique_ptr<MeasureMenu> measure_;
    std::unique_ptr<AppearanceMenu> appearance_;
    std::unique_ptr<ExerciseMenu> exercise_;
    std::unique_ptr<WelcomeEntry> welcome_;
    std::unique_ptr<HelpMenu> help_;
};

}  // namespace tactooth

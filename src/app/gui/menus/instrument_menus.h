// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/settings/window_settings.h"

class QAction;
class QActionGroup;
class QMenu;

namespace tactooth {

class InstrumentSet;

/// The switches of what is around the bur: water, suction tube and mouth mirror.
class InstrumentMenus final : public QObject {
    Q_OBJECT

public:
    /// `instruments` outlive the menus.
    explicit InstrumentMenus(InstrumentSet& instruments) : instruments_(instruments) {}

    /// Water and suction. Call each of the two once.
    void addSpraySwitches(QMenu& menu);
    /// A submenu with the mirror's size, fog and drops, and whether it dims by itself.
    void addMirrorMenu(QMenu& menu);

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    void setMirror(const MirrorSettings& mirror);
    void updateMirror();

    InstrumentSet& instruments_;
    QAction* water_ = nullptr;
    QAction* suction_ = nullptr;
    QActionGroup* sizes_ = nullptr;
    QAction* fog_ = nullptr;
    QAction* drops_ = nullptr;
    QAction* dims_ = nullptr;
};

}  // namespace tactooth

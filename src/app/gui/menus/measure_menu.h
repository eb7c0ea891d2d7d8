// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>

#include "app/gui/keys/key_table.h"
#include "session/control/surface_measure.h"

class QAction;
class QMenu;

namespace tactooth {

class MeasureTool;
class ToothView;

/// The entries that begin, clear and end a measurement, in a menu of their own.
class MeasureMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds a submenu to `menu`; `view` outlives it.
    MeasureMenu(QMenu& menu, ToothView& view);

private:
    void add(QMenu& menu, const QString& text, KeyId key, const char* name, MeasureKind kind, const QString& tip);
    void showState();

    ToothView& view_;
    MeasureTool& tool_;
    std::map<MeasureKind, QAction*> kinds_;
    QAction* clear_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/keys/key_table.h"
#include "app/gui/settings/window_settings.h"

class QAction;
class QMenu;

namespace tactooth {

class ToothView;

/// The switches of what helps to find one's way in the picture, in a menu of their own.
class ViewAidsMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds a submenu to `menu`; `view` outlives it.
    ViewAidsMenu(QMenu& menu, ToothView& view);

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;

private:
    QAction* add(QMenu& menu, const QString& text, KeyId key, const char* name, const char* icon, const QString& tip);
    [[nodiscard]] ViewAids aids() const;
    void show();

    ToothView& view_;
    QAction* glass_;
    QAction* magnifier_;
    QAction* scaleBar_;
    QAction* letters_;
    QAction* cube_;
    QAction* softTissues_;
};

}  // namespace tactooth

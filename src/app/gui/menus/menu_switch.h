// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace tactooth {

/// Adds an action that the user switches on and off by the menu or by `keys`. `name`: its object name.
inline QAction* addSwitch(QMenu& menu, const QString& text, const QString& keys, const QString& name = {}) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setShortcut(QKeySequence(keys));
    if (!name.isEmpty()) action->setObjectName(name);
    return action;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QRegularExpression>

#include "app/gui/keys/key_binding.h"

namespace tactooth {

/// Lets tool bars show the text of a menu's entry without its keyboard mark: neither "&Open" nor, in Japanese,
/// "開く(&O)".
inline void hideMarkInBars(QAction& action) {
    static const QRegularExpression kMark(R"(\(&\w\)|&)");
    action.setIconText(action.text().remove(kMark));
}

/// Adds an action that the user switches on and off by the menu or by its key. `name`: its object name.
inline QAction* addSwitch(QMenu& menu, const QString& text, KeyId key, const QString& name = {}) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    bindKey(*action, key);
    if (!name.isEmpty()) action->setObjectName(name);
    return action;
}

}  // namespace tactooth

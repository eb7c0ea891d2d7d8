// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/keys/key_map.h"

class QAction;
class QShortcut;
class QWidget;

namespace tactooth {

/// Gives the row's usual key to an action; applyKeys changes it. `tip`: its tool tip, with %1 for the key; empty: none.
void bindKey(QAction& action, KeyId id, const QString& tip = {});
/// The same for a shortcut of its own, with the widget whose tool tip names the key.
void bindKey(QShortcut& shortcut, KeyId id, QWidget& tipped, const QString& tip);

/// Another tool tip for an action that has a key, with %1 for it.
void setTip(QAction& action, const QString& tip);

/// Gives the keys of `map` to all actions and shortcuts below `window` that are bound to a row.
void applyKeys(QWidget& window, const KeyMap& map);

/// The keys of a row in one text, as the desktop writes them: "Ctrl+Shift+Z, Ctrl+Y".
[[nodiscard]] QString keysText(const Keys& keys);
/// The first key of an action, as the desktop writes it.
[[nodiscard]] QString keyOf(const QAction& action);

}  // namespace tactooth

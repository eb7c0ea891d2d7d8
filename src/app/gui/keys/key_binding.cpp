// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys/key_binding.h"

#include <QAction>
#include <QShortcut>
#include <QWidget>

namespace tactooth {
namespace {

// Properties of what is bound: the row, the tool tip with a place for the key, and who shows it.
constexpr const char* kRow = "keyRow";
constexpr const char* kTip = "keyTip";
constexpr const char* kTipped = "keyTipped";

Keys keysOf(const QObject& bound, const KeyMap& map) {
    return map.keys(static_cast<KeyId>(bound.property(kRow).toInt()));
}

QString tipOf(const QObject& bound, const Keys& keys) { return bound.property(kTip).toString().arg(keysText(keys)); }

void show(QAction& action, const Keys& keys) {
    action.setShortcuts(keys);
    if (action.property(kTip).isValid()) action.setToolTip(tipOf(action, keys));
}

void show(QShortcut& shortcut, const Keys& keys) {
    shortcut.setKeys(keys);
    auto* const tipped = shortcut.property(kTipped).value<QWidget*>();
    if (tipped != nullptr) tipped->setToolTip(tipOf(shortcut, keys));
}

}  // namespace

void bindKey(QAction& action, KeyId id, const QString& tip) {
    action.setProperty(kRow, static_cast<int>(id));
    if (!tip.isEmpty()) action.setProperty(kTip, tip);
    show(action, KeyMap::usual(id));
}

void setTip(QAction& action, const QString& tip) {
    action.setProperty(kTip, tip);
    action.setToolTip(tipOf(action, action.shortcuts()));
}

void bindKey(QShortcut& shortcut, KeyId id, QWidget& tipped, const QString& tip) {
    shortcut.setProperty(kRow, static_cast<int>(id));
    shortcut.setProperty(kTip, tip);
    shortcut.setProperty(kTipped, QVariant::fromValue(&tipped));
    show(shortcut, KeyMap::usual(id));
}

void applyKeys(QWidget& window, const KeyMap& map) {
    for (auto* const action : window.findChildren<QAction*>()) {
        if (action->property(kRow).isValid()) show(*action, keysOf(*action, map));
    }
    for (auto* const shortcut : window.findChildren<QShortcut*>()) {
        if (shortcut->property(kRow).isValid()) show(*shortcut, keysOf(*shortcut, map));
    }
}

QString keysText(const Keys& keys) {
    QStringList names;
    for (const QKeySequence& key : keys) names << nativeText(key);
    return names.join(", ");
}

QString keyOf(const QAction& action) { return nativeText(action.shortcut()); }

}  // namespace tactooth

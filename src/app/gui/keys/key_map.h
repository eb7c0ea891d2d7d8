// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/keys/key_table.h"

namespace tactooth {

/// The keys of one row. A modifier is the key of that name (Qt::Key_Shift).
using Keys = QList<QKeySequence>;

/// Which key does what: the table of keys with the user's own keys in it. No key does two things where both work.
class KeyMap {
public:
    /// The usual keys.
    KeyMap();

    [[nodiscard]] const Keys& keys(KeyId id) const { return keys_[static_cast<std::size_t>(id)]; }
    [[nodiscard]] bool isUsual(KeyId id) const { return keys(id) == usual(id); }
    [[nodiscard]] static Keys usual(KeyId id);
    /// The key of a row that is not a Shortcut.
    [[nodiscard]] Qt::Key key(KeyId id) const;
    /// That of a row of modifiers.
    [[nodiscard]] Qt::KeyboardModifier modifier(KeyId id) const;

    /// Why these cannot be the keys of the row: a sentence; none: they can.
    [[nodiscard]] std::optional<Message> objection(KeyId id, const Keys& wanted) const;
    /// There is no objection.
    void set(KeyId id, const Keys& wanted);

    /// The user's own keys for the settings, one a line: "cut = F5". The key of the pedal has a setting of its own.
    [[nodiscard]] std::string ownText() const;
    /// Takes both settings. What cannot be used gets its usual key; the result says why, one sentence for each.
    std::vector<Message> restore(const std::string& ownText, const std::string& pedalKey);

private:
    [[nodiscard]] Keys claims(KeyId id) const;
    [[nodiscard]] bool clash(KeyId a, KeyId b) const;
    [[nodiscard]] std::optional<KeyId> rivalOf(KeyId id) const;
    [[nodiscard]] std::optional<Message> assign(const std::string& name, const std::string& text);

    std::vector<Keys> keys_;
};

/// "Ctrl+Z" in Qt's English.
[[nodiscard]] QString portableText(const QKeySequence& key);
/// The same as the desktop writes it.
[[nodiscard]] QString nativeText(const QKeySequence& key);
/// The keys that such a text names; none if it is not one.
[[nodiscard]] Keys keysFrom(const QString& portable, KeyKind kind);

/// What the picture needs of the map.
struct PictureKeys {
    Qt::Key left, right, up, down, press, nearer, farther, holdMirror;
    Qt::KeyboardModifier lean, turn, zoom, fineDepth;

    explicit PictureKeys(const KeyMap& map = {});
};

}  // namespace tactooth

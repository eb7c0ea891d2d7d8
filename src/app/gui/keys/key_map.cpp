// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys/key_map.h"

#include <QStringList>
#include <algorithm>
#include <array>

#include "app/gui/keys/messages.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

struct ModifierName {
    Qt::Key key;
    Qt::KeyboardModifier modifier;
    const char* name;
};
constexpr std::array kModifiers = {
    ModifierName{Qt::Key_Shift, Qt::ShiftModifier, "Shift"}, ModifierName{Qt::Key_Control, Qt::ControlModifier, "Ctrl"},
    ModifierName{Qt::Key_Alt, Qt::AltModifier, "Alt"}, ModifierName{Qt::Key_Meta, Qt::MetaModifier, "Meta"}};

bool isModifierRow(KeyKind kind) { return kind == KeyKind::HandModifier || kind == KeyKind::WheelModifier; }

const ModifierName* modifierOf(const QKeySequence& key) {
    if (key.count() != 1) return nullptr;
    const auto* const found = std::ranges::find(kModifiers, key[0].key(), &ModifierName::key);
    return found == kModifiers.end() ? nullptr : found;
}

/// In the sentence the action bears its name in both languages.
Message taken(const QKeySequence& key, KeyId by) {
    return {msg::kKeyTaken, portableText(key).toStdString(), *keyRow(by).text};
}

}  // namespace

QString portableText(const QKeySequence& key) {
    const ModifierName* const modifier = modifierOf(key);
    return modifier != nullptr ? QString(modifier->name) : key.toString(QKeySequence::PortableText);
}

QString nativeText(const QKeySequence& key) {
    return modifierOf(key) != nullptr ? portableText(key) : key.toString(QKeySequence::NativeText);
}

Keys keysFrom(const QString& portable, KeyKind kind) {
    const QString text = portable.trimmed();
    if (isModifierRow(kind)) {
        const auto* const found = std::ranges::find_if(
            kModifiers, [&](const ModifierName& each) { return text.compare(each.name, Qt::CaseInsensitive) == 0; });
        return found == kModifiers.end() ? Keys() : Keys{QKeySequence(found->key)};
    }
    Keys result;
    for (const QKeySequence& each : QKeySequence::listFromString(text, QKeySequence::PortableText)) {
        if (each.count() != 1 || each[0].key() == Qt::Key_unknown || modifierOf(each) != nullptr) return {};
        result << (kind == KeyKind::Shortcut ? each : QKeySequence(each[0].key()));
    }
    const bool isOne = kind == KeyKind::Shortcut || result.size() == 1;
    return isOne ? result : Keys();
}

KeyMap::KeyMap() {
    for (const KeyRow& row : keyTable()) keys_.push_back(usual(row.id));
}

Keys KeyMap::usual(KeyId id) {
    Keys keys = keysFrom(keyRow(id).usual, keyRow(id).kind);
    TACTOOTH_ASSERT(!keys.isEmpty());
    return keys;
}

Qt::Key KeyMap::key(KeyId id) const {
    TACTOOTH_ASSERT(keyRow(id).kind != KeyKind::Shortcut);
    return keys(id).front()[0].key();
}

Qt::KeyboardModifier KeyMap::modifier(KeyId id) const {
    const ModifierName* const found = modifierOf(keys(id).front());
    TACTOOTH_ASSERT(found != nullptr);
    return found->modifier;
}

/// All that the row takes for itself: an arrow also works with the modifiers of the hand.
Keys KeyMap::claims(KeyId id) const {
    const KeyKind kind = keyRow(id).kind;
    if (isModifierRow(kind)) return {};
    Keys result = keys(id);
    if (id == KeyId::Press && key(id) == Qt::Key_Return) result << QKeySequence(Qt::Key_Enter);
    if (kind != KeyKind::Arrow) return result;
    for (const KeyId with : {KeyId::Lean, KeyId::TurnTooth}) {
        result << QKeySequence(QKeyCombination(modifier(with), key(id)));
    }
    return result;
}

bool KeyMap::clash(KeyId a, KeyId b) const {
    const KeyRow &first = keyRow(a), &second = keyRow(b);
    if (isModifierRow(first.kind)) return first.kind == second.kind && keys(a) == keys(b);
    // Nothing is cut in a replay: the pedal and the press rest.
    const bool isHeld = a == KeyId::Pedal || a == KeyId::Press || b == KeyId::Pedal || b == KeyId::Press;
    if (isHeld && (first.group == KeyGroup::Replay || second.group == KeyGroup::Replay)) return false;
    const Keys others = claims(b);
    return std::ranges::any_of(claims(a), [&](const QKeySequence& each) { return others.contains(each); });
}

/// A row that wants the same key: of a modifier, also one that meets an arrow with it.
std::optional<KeyId> KeyMap::rivalOf(KeyId id) const {
    for (const KeyRow& row : keyTable()) {
        if (row.id != id && clash(id, row.id)) return row.id;
    }
    if (keyRow(id).kind != KeyKind::HandModifier) return std::nullopt;
    for (const KeyRow& arrow : keyTable()) {
        if (arrow.kind != KeyKind::Arrow) continue;
        for (const KeyRow& row : keyTable()) {
            if (row.id != arrow.id && clash(arrow.id, row.id)) return row.id;
        }
    }
    return std::nullopt;
}

std::optional<Message> KeyMap::objection(KeyId id, const Keys& wanted) const {
    TACTOOTH_ASSERT(!wanted.isEmpty());
    const bool wantsModifier = isModifierRow(keyRow(id).kind);
    for (const QKeySequence& key : wanted) {
        const std::string name = portableText(key).toStdString();
        if (wantsModifier && modifierOf(key) == nullptr) return Message(msg::kKeyWantsModifier, name);
        if (wantsModifier) continue;
        const Qt::Key code = key[0].key();
        const Qt::KeyboardModifiers with = key[0].keyboardModifiers();
        if (code == Qt::Key_Tab || code == Qt::Key_Backtab) return Message(msg::kKeyMovesFocus, name);
        const bool isLetter = code >= Qt::Key_A && code <= Qt::Key_Z;
        if (code == Qt::Key_F10 || (with == Qt::AltModifier && isLetter)) return Message(msg::kKeyOpensMenus, name);
    }
    KeyMap changed = *this;
    changed.keys_[static_cast<std::size_t>(id)] = wanted;
    const std::optional<KeyId> rival = changed.rivalOf(id);
    if (!rival) return std::nullopt;
    const Keys theirs = changed.claims(*rival);
    const auto shared = std::ranges::find_if(wanted, [&](const QKeySequence& each) { return theirs.contains(each); });
    return taken(shared != wanted.end() ? *shared : wanted.front(), *rival);
}

void KeyMap::set(KeyId id, const Keys& wanted) {
    TACTOOTH_ASSERT(!objection(id, wanted));
    keys_[static_cast<std::size_t>(id)] = wanted;
}

std::string KeyMap::ownText() const {
    std::string text;
    for (const KeyRow& row : keyTable()) {
        if (row.id == KeyId::Pedal || isUsual(row.id)) continue;
        QStringList names;
        for (const QKeySequence& key : keys(row.id)) names << portableText(key);
        text += std::string(text.empty() ? "" : "\n") + row.name + " = " + names.join("; ").toStdString();
    }
    return text;
}

/// Takes one line, whatever the other rows have.
std::optional<Message> KeyMap::assign(const std::string& name, const std::string& text) {
    for (const KeyRow& row : keyTable()) {
        if (name != row.name) continue;
        const Keys wanted = keysFrom(QString::fromStdString(text), row.kind);
        if (wanted.isEmpty()) return Message(msg::kKeyUnknown, text);
        keys_[static_cast<std::size_t>(row.id)] = wanted;
        return std::nullopt;
    }
    return Message(msg::kKeyRowUnknown, name);
}

std::vector<Message> KeyMap::restore(const std::string& ownText, const std::string& pedalKey) {
    *this = KeyMap();
    std::vector<Message> refused;
    const auto take = [&](const std::string& name, const std::string& text) {
        if (const auto fault = assign(name, text)) refused.push_back(*fault);
    };
    for (const QString& line : QString::fromStdString(ownText).split('\n', Qt::SkipEmptyParts)) {
        const qsizetype sign = line.indexOf('=');
        take(line.left(sign).trimmed().toStdString(), sign < 0 ? "" : line.mid(sign + 1).trimmed().toStdString());
    }
    if (!pedalKey.empty()) take(keyRow(KeyId::Pedal).name, pedalKey);
    // A row with its usual key stays; the pedal has the right before the others. All usual keys together do not clash.
    for (bool isClean = false; !isClean;) {
        isClean = true;
        for (auto row = keyTable().rbegin(); row != keyTable().rend(); ++row) {
            const Keys wanted = keys(row->id);
            if (isUsual(row->id)) continue;
            const std::optional<Message> fault = objection(row->id, wanted);
            if (!fault) continue;
            refused.push_back(*fault);
            keys_[static_cast<std::size_t>(row->id)] = usual(row->id);
            isClean = false;
        }
    }
    return refused;
}

PictureKeys::PictureKeys(const KeyMap& map)
    : left(map.key(KeyId::MoveLeft)),
      right(map.key(KeyId::MoveRight)),
      up(map.key(KeyId::MoveUp)),
      down(map.key(KeyId::MoveDown)),
      press(map.key(KeyId::Press)),
      nearer(map.key(KeyId::Nearer)),
      farther(map.key(KeyId::Farther)),
      holdMirror(map.key(KeyId::HoldMirror)),
      lean(map.modifier(KeyId::Lean)),
      turn(map.modifier(KeyId::TurnTooth)),
      zoom(map.modifier(KeyId::Zoom)),
      fineDepth(map.modifier(KeyId::FineDepth)) {}

}  // namespace tactooth

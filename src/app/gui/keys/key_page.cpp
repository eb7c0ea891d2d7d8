// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys/key_page.h"

#include "app/gui/keys/messages.h"

namespace tactooth {
namespace {

/// Markdown must not take the signs of a key for its own.
std::string escaped(const QString& key) {
    QString text;
    for (const QChar sign : key) {
        if (QString("\\`*_{}[]()#+-.!|<>~").contains(sign)) text += '\\';
        text += sign;
    }
    return text.toStdString();
}

}  // namespace

std::string keyPage(const KeyMap& map, Language language, const std::string& note, const KeyWriter& write) {
    const auto say = [language](const MessageText& text) { return std::string(text.in(language)); };
    const auto head = [&](const MessageText& title) {
        return "\n## " + say(title) + "\n\n| " + say(msg::kKeyColumnKey) + " | " + say(msg::kKeyColumnWhat) +
               " |\n|---|---|\n";
    };
    std::string page = "# " + say(msg::kKeyPageTitle) + "\n\n" + note + "\n";
    for (const FixedControls& part : fixedControls()) {
        page += head(*part.title);
        for (const FixedControls::Row& row : part.rows) {
            page += "| **" + say(*row.what) + "** | " + say(*row.effect) + " |\n";
        }
    }
    const KeyRow* before = nullptr;
    for (const KeyRow& row : keyTable()) {
        if (before == nullptr || before->group != row.group) page += head(titleOf(row.group));
        before = &row;
        std::string keys;
        for (const QKeySequence& key : map.keys(row.id)) {
            const std::string name = "**" + escaped(write(key)) + "**";
            keys = keys.empty() ? name : Message(msg::kKeyOr, keys, name).in(language);
        }
        page += "| " + keys + " | " + say(*row.text) + " |\n";
    }
    return page;
}

std::string keyPageFile(Language language) {
    const std::string note =
        std::string(msg::kKeyPageMade.in(language)) + "\n" + std::string(msg::kKeyPageChange.in(language));
    return keyPage({}, language, note, portableText);
}

std::string ownKeyPage(const KeyMap& map, Language language) {
    return keyPage(map, language, std::string(msg::kKeyPageOwn.in(language)), nativeText);
}

}  // namespace tactooth

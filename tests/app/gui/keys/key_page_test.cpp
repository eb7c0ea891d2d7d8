// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys/key_page.h"

#include <gmock/gmock.h>

namespace tactooth {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(KeyPage, NamesEachRowInBothLanguages) {
    for (const Language language : {Language::English, Language::Japanese}) {
        const std::string page = keyPageFile(language);
        for (const KeyRow& row : keyTable()) {
            EXPECT_THAT(page, HasSubstr("| " + std::string(row.text->in(language)) + " |"));
        }
        for (const FixedControls& part : fixedControls()) {
            EXPECT_THAT(page, HasSubstr("## " + std::string(part.title->in(language)) + "\n"));
        }
    }
}

TEST(KeyPage, ShowsTheKeysOfTheMap) {
    KeyMap map;
    map.set(KeyId::Cut, {QKeySequence("F11"), QKeySequence("Ctrl+*")});
    const std::string page = ownKeyPage(map, Language::English);
    EXPECT_THAT(page, HasSubstr("| **F11** or **Ctrl\\+\\*** | Cut |"));
    EXPECT_THAT(page, Not(HasSubstr("| **C** |")));
    EXPECT_THAT(keyPageFile(Language::English), HasSubstr("| **C** | Cut |"));
}

}  // namespace
}  // namespace tactooth

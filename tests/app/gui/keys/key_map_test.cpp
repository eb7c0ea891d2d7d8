// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys/key_map.h"

#include <gtest/gtest.h>

#include <set>

#include "app/gui/keys/messages.h"

namespace tactooth {
namespace {

Keys keys(const char* text, KeyId id) { return keysFrom(text, keyRow(id).kind); }

TEST(KeyTable, NamesAreUniqueAndKeysAreKnown) {
    std::set<std::string> names;
    for (const KeyRow& row : keyTable()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_FALSE(keysFrom(row.usual, row.kind).isEmpty()) << row.name;
    }
    EXPECT_GT(names.size(), 50U);
}

TEST(KeyMap, UsualKeysDoNotClash) {
    const KeyMap map;
    for (const KeyRow& row : keyTable()) {
        const auto fault = map.objection(row.id, KeyMap::usual(row.id));
        EXPECT_FALSE(fault) << row.name << ": " << (fault ? fault->in(Language::English) : "");
    }
    EXPECT_EQ(map.ownText(), "");
}

TEST(KeyMap, AKeyInUseIsRefusedByTheNameOfItsAction) {
    const KeyMap map;
    const auto fault = map.objection(KeyId::Touch, keys("C", KeyId::Touch));
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->in(Language::English), "C is the key of “Cut”: give that another key first.");
    EXPECT_EQ(fault->in(Language::Japanese), "C は「切削」のキーです。先にそちらのキーを変えてください。");
    EXPECT_TRUE(map.objection(KeyId::Nearer, keys("C", KeyId::Nearer)));        // the picture's keys count
    EXPECT_TRUE(map.objection(KeyId::Touch, keys("Left", KeyId::Touch)));       // and the arrows,
    EXPECT_TRUE(map.objection(KeyId::Touch, keys("Ctrl+Left", KeyId::Touch)));  // also with a modifier of the hand
    EXPECT_TRUE(map.objection(KeyId::Touch, keys("Enter", KeyId::Touch)));
    EXPECT_TRUE(map.objection(KeyId::Touch, keys("Space", KeyId::Touch)));
    EXPECT_TRUE(map.objection(KeyId::Touch, keys("Ctrl+Y", KeyId::Touch)));  // the second key of Redo
    EXPECT_FALSE(map.objection(KeyId::Touch, keys("Alt+Left", KeyId::Touch)));
    EXPECT_FALSE(map.objection(KeyId::Touch, keys("F9", KeyId::Touch)));
}

TEST(KeyMap, AKeyIsFreeOnceItsActionHasAnother) {
    KeyMap map;
    map.set(KeyId::Cut, keys("F11", KeyId::Cut));
    EXPECT_FALSE(map.objection(KeyId::Touch, keys("C", KeyId::Touch)));
    map.set(KeyId::Touch, keys("C", KeyId::Touch));
    EXPECT_TRUE(map.objection(KeyId::Cut, KeyMap::usual(KeyId::Cut)));
    EXPECT_FALSE(map.isUsual(KeyId::Cut));
}

TEST(KeyMap, ModifiersMustDifferWhereBothWork) {
    KeyMap map;
    EXPECT_TRUE(map.objection(KeyId::Lean, keys("Ctrl", KeyId::Lean)));
    EXPECT_TRUE(map.objection(KeyId::Zoom, keys("Shift", KeyId::Zoom)));
    EXPECT_FALSE(map.objection(KeyId::Lean, keys("Alt", KeyId::Lean)));
    map.set(KeyId::Touch, keys("Alt+Left", KeyId::Touch));
    EXPECT_TRUE(map.objection(KeyId::Lean, keys("Alt", KeyId::Lean)));  // Alt with an arrow would lean
    EXPECT_EQ(map.objection(KeyId::Lean, {QKeySequence(Qt::Key_L)})->id(), msg::kKeyWantsModifier.id);
}

TEST(KeyMap, KeysOfMenusAndOfTheFocusAreRefused) {
    const KeyMap map;
    EXPECT_EQ(map.objection(KeyId::Touch, keys("Tab", KeyId::Touch))->id(), msg::kKeyMovesFocus.id);
    EXPECT_EQ(map.objection(KeyId::Touch, keys("Alt+F", KeyId::Touch))->id(), msg::kKeyOpensMenus.id);
    EXPECT_EQ(map.objection(KeyId::Touch, keys("F10", KeyId::Touch))->id(), msg::kKeyOpensMenus.id);
}

TEST(KeyMap, NothingIsCutInAReplay) {
    const KeyMap map;
    EXPECT_FALSE(map.objection(KeyId::ReplayOn, keys("Return", KeyId::ReplayOn)));
    EXPECT_TRUE(map.objection(KeyId::ReplayOn, keys("F", KeyId::ReplayOn)));
}

TEST(KeyMap, OwnKeysComeBackFromTheSettings) {
    KeyMap map;
    map.set(KeyId::Cut, keys("F11", KeyId::Cut));
    map.set(KeyId::Touch, keys("C", KeyId::Touch));
    map.set(KeyId::Help, keys("Ctrl+=", KeyId::Help));
    map.set(KeyId::ReplayBack, keys("Ctrl+.", KeyId::ReplayBack));
    map.set(KeyId::Undo, keys("Ctrl+Z; F12", KeyId::Undo));
    map.set(KeyId::Lean, keys("Alt", KeyId::Lean));
    map.set(KeyId::Pedal, keys("F8", KeyId::Pedal));
    KeyMap read;
    EXPECT_TRUE(read.restore(map.ownText(), "F8").empty());
    for (const KeyRow& row : keyTable()) EXPECT_EQ(read.keys(row.id), map.keys(row.id)) << row.name;
    EXPECT_EQ(read.ownText(), map.ownText());
    EXPECT_EQ(read.ownText().find("pedal"), std::string::npos);
}

TEST(KeyMap, DamagedLinesGetTheUsualKeyAndTheOthersStay) {
    KeyMap map;
    const auto refused =
        map.restore("cut = F11\nfly = F12\ntouch = Hyper+Q\nnonsense\nfit = G\n= =\nlean = X", "Space");
    ASSERT_EQ(refused.size(), 6U);
    EXPECT_EQ(map.ownText(), "cut = F11");
    EXPECT_TRUE(map.restore("cut = F11", "Space").empty());
}

TEST(KeyMap, AnyTextLeavesKeysThatDoNotClash) {
    const char* const texts[] = {"touch = C\ncut = T",  // an exchange
                                 "touch = C\ncut = C",
                                 "touch = C",
                                 "pedal = F1",
                                 "move_left = Right\nmove_right = Left",
                                 "lean = Ctrl\nturn_tooth = Shift",
                                 "touch = ",
                                 "touch = F5; F11\ncut = F11",
                                 "touch = Ctrl+X, Ctrl+Y"};
    for (const char* text : texts) {
        KeyMap map;
        (void)map.restore(text, "C");
        for (const KeyRow& row : keyTable()) EXPECT_FALSE(map.objection(row.id, map.keys(row.id))) << text << row.name;
    }
    KeyMap map;
    EXPECT_TRUE(map.restore(texts[0], "Space").empty());
}

TEST(KeyMap, AHeldKeyHasNoModifiers) {
    EXPECT_EQ(keys("Ctrl+P", KeyId::Press), Keys{QKeySequence(Qt::Key_P)});
    EXPECT_TRUE(keys("P; Q", KeyId::Press).isEmpty());
    EXPECT_TRUE(keys("Shift", KeyId::Press).isEmpty());
}

TEST(KeyMap, ThePictureGetsItsKeys) {
    KeyMap map;
    map.set(KeyId::MoveLeft, keys(";", KeyId::MoveLeft));
    map.set(KeyId::Lean, keys("Alt", KeyId::Lean));
    const PictureKeys picture(map);
    EXPECT_EQ(picture.left, Qt::Key_Semicolon);
    EXPECT_EQ(picture.right, Qt::Key_Right);
    EXPECT_EQ(picture.lean, Qt::AltModifier);
    EXPECT_EQ(picture.fineDepth, Qt::ShiftModifier);
}

}  // namespace
}  // namespace tactooth

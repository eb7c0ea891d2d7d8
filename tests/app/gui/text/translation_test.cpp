// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/translation.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>
#include <string>

#include "assessment/exercise.h"
#include "devices/openhaptics/hd_library.h"
#include "geometry/files/file_bytes.h"
#include "instruments/bur_catalogue.h"
#include "instruments/spindle.h"
#include "session/io/material_file.h"
#include "support/shapes.h"
#include "tooth/model/layered_tooth.h"
#include "tooth/model/material.h"
#include "tooth/model/material_word.h"

namespace tactooth {
namespace {

/// No language is chosen.
class Translation : public ::testing::Test {};

/// The window speaks Japanese.
class JapaneseTranslation : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(japanese_.load(":/translations/tactooth_ja.qm"));
        QCoreApplication::installTranslator(&japanese_);
    }
    void TearDown() override { QCoreApplication::removeTranslator(&japanese_); }

    int argc_ = 1;
    char name_[6] = "tests";
    char* argv_[2] = {name_, nullptr};
    QCoreApplication application_{argc_, argv_};
    QTranslator japanese_;
};

/// Whether every letter is of the Latin alphabet.
bool isLatin(const QString& text) {
    for (const QChar letter : text) {
        if (letter.unicode() >= 0x3000) return false;
    }
    return true;
}

TEST_F(Translation, IsTheMessageInEnglishWhereNoLanguageIsChosen) {
    EXPECT_EQ(windowLanguage(), Language::English);
    const auto missing = readFile("/no/such/tooth.stl");
    EXPECT_EQ(translated(missing.error()).toStdString(), missing.error().message());
    EXPECT_EQ(translated("Pit in the molar"), "Pit in the molar");
}

TEST_F(JapaneseTranslation, FollowsTheTranslator) {
    EXPECT_EQ(windowLanguage(), Language::Japanese);
    EXPECT_EQ(translated(readFile("/no: a/tooth.stl").error()),
              QStringLiteral("/no: a/tooth.stl：ファイルがありません。名前とフォルダーを確かめてください。"));
}

TEST_F(JapaneseTranslation, ReachesMessagesWithinMessages) {
    TriangleMesh open = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    open.triangles.pop_back();
    const auto tooth = LayeredTooth::make(open, {});
    ASSERT_FALSE(tooth);
    EXPECT_EQ(translated(tooth.error()),
              QStringLiteral("歯の表面が閉じておらず（隣のない辺 3 本）、削る内部がありません。"
                             "先に穴をふさいでください"));
    const auto materials = parseMaterials("[enamel]\ncolour = [1, 2]\n", "m.toml", {});
    ASSERT_FALSE(materials);
    EXPECT_EQ(translated(materials.error()),
              QStringLiteral("m.toml、2 行目：'colour' は角括弧で囲んだ三つの数値（赤、緑、青）でなければなりません"
                             "（実際の値：要素 2 個のリスト）。"));
}

TEST_F(JapaneseTranslation, HasWordsForEachErrorOfAPen) {
    for (std::uint32_t code = 0; code < 0x1000; ++code) EXPECT_FALSE(isLatin(translated(hdErrorMessage(code)))) << code;
}

TEST_F(JapaneseTranslation, HasWordsForEachExerciseSpindleAndMaterial) {
    for (const auto& exercise : exercises()) {
        EXPECT_FALSE(isLatin(translated(exercise->name))) << exercise->name;
        EXPECT_FALSE(isLatin(translated(exercise->task))) << exercise->task;
    }
    for (const SpindlePreset& spindle : spindlePresets()) EXPECT_FALSE(isLatin(translated(spindle.name)));
    for (std::size_t id = 0; id < kMaterialCount; ++id) {
        const std::string_view name = materialName(static_cast<MaterialId>(id));
        EXPECT_FALSE(isLatin(translated(materialWord(name)))) << name;
    }
}

TEST_F(JapaneseTranslation, HasWordsForEachBur) {
    for (const BurSpec& bur : burCatalogue()) {
        EXPECT_EQ(bur.title.in(Language::English), bur.name);
        EXPECT_FALSE(isLatin(translated(bur.title))) << bur.name;
    }
}

TEST_F(JapaneseTranslation, LeavesOtherNamesAsTheyAre) {
    EXPECT_EQ(translated("molar.stl"), "molar.stl");
    EXPECT_EQ(translated(materialWord("zirconia")), "zirconia");
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/translation.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QStringList>
#include <QTranslator>
#include <string>

#include "assessment/exercise.h"
#include "devices/open_device.h"
#include "devices/openhaptics/hd_library.h"
#include "devices/probe/device_backend.h"
#include "geometry/files/file_bytes.h"
#include "instruments/bur_catalogue.h"
#include "instruments/spindle.h"
#include "patient/scan_import.h"
#include "session/io/material_file.h"
#include "session/model/session_tooth.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "tooth/model/layered_tooth.h"
#include "tooth/model/material_registry.h"

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
    EXPECT_EQ(inWindowLanguage("Time", "時間"), "Time");
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
    const auto materials = parseMaterials("[enamel]\ncolour = [1, 2]\n", "m.toml");
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
        const ExerciseWords words = exercise->words(windowLanguage());
        EXPECT_FALSE(isLatin(QString::fromStdString(words.task))) << exercise->task;
        EXPECT_FALSE(isLatin(QString::fromStdString(words.brief))) << exercise->brief;
    }
    for (const SpindlePreset& spindle : spindlePresets()) EXPECT_FALSE(isLatin(translated(spindle.name)));
    for (const MaterialDefinition& material : builtinMaterials().definitions()) {
        EXPECT_FALSE(isLatin(materialTitle(material))) << material.name;
    }
}

TEST_F(JapaneseTranslation, HasWordsForEachBuiltinTooth) {
    for (const BuiltinToothEntry& tooth : kBuiltinTeeth) EXPECT_FALSE(isLatin(translated(tooth.name))) << tooth.name;
}

TEST_F(JapaneseTranslation, NamesTheLayersOfAScanInImportNotes) {
    const std::vector<LayerMesh> layers = {{"dentin", test::kDentin, test::box(Vec3(-3, -3, -12), Vec3(3, 3, 0))},
                                           {"enamel", test::kEnamel, test::box(Vec3(-3, -3, 0), Vec3(3, 3, 8))}};
    const auto scan = examineScan({"a", {}, layers}, {});
    ASSERT_TRUE(scan) << scan.error().message();
    QString words;
    for (const ImportNote& note : scan->importNotes) words += translated(note.message);
    EXPECT_TRUE(words.contains(QStringLiteral("象牙質：もとから閉じていて"))) << words.toStdString();
}

TEST_F(JapaneseTranslation, ShowsWordsOfATableThatHasBothLanguages) {
    EXPECT_EQ(inWindowLanguage("Time", "時間"), "時間");
    EXPECT_EQ(translated(Message::bilingual("gold", "金")), "金");
}

TEST_F(JapaneseTranslation, NamesTheDevicesThatCanBeChosen) {
    QStringList names, units;
    for (const DeviceBackend& each : deviceBackends()) {
        names << QString::fromUtf8(each.name);
        if (each.unitWord != nullptr) units << names.back() + ':' + QString::fromUtf8(each.unitWord);
    }
    ASSERT_GE(units.size(), 2);
    const QString last = units.takeLast();
    EXPECT_EQ(translated(openDevice("joystick").error()),
              QStringLiteral("--device に 'joystick' は指定できません。%1、複数あるうちの一つなら %2 か %3、または "
                             "replay:FILE.csv を指定してください。'tactooth devices' で接続中の装置が分かります。")
                  .arg(names.join(", "), units.join(", "), last));
}

TEST_F(JapaneseTranslation, HasWordsForEachBur) {
    for (const BurSpec& bur : burCatalogue()) {
        EXPECT_EQ(bur.title.in(Language::English), bur.name);
        EXPECT_FALSE(isLatin(translated(bur.title))) << bur.name;
    }
}

TEST_F(JapaneseTranslation, LeavesOtherNamesAsTheyAre) { EXPECT_EQ(translated("molar.stl"), "molar.stl"); }

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/text/error_translation.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QTranslator>
#include <cmath>

#include "devices/base/pose_monitor.h"
#include "devices/haply/haply_message.h"
#include "devices/open_device.h"
#include "devices/openhaptics/hd_library.h"
#include "geometry/files/file_bytes.h"
#include "session/io/material_file.h"
#include "support/shapes.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {
namespace {

/// `sentence` with a name in each of its places.
QString withNames(QString sentence) {
    for (int place = 1; place <= 5; ++place) sentence.replace('%' + QString::number(place), QString("q%1").arg(place));
    return sentence;
}

QString inEnglish(const std::string& message) { return QString::fromStdString(message); }

/// No language is chosen.
class ErrorTranslation : public ::testing::Test {};

/// The window speaks Japanese.
class JapaneseErrorTranslation : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(japanese_.load(":/translations/tactooth_ja.qm"));
        QCoreApplication::installTranslator(&japanese_);
    }
    void TearDown() override { QCoreApplication::removeTranslator(&japanese_); }

    /// No word is left as it was; keys and names are.
    static void expectSaid(const std::string& message) {
        EXPECT_NE(translatedError(message), inEnglish(message)) << message;
    }

    int argc_ = 1;
    char name_[6] = "tests";
    char* argv_[2] = {name_, nullptr};
    QCoreApplication application_{argc_, argv_};
    QTranslator japanese_;
};

TEST_F(ErrorTranslation, AreTheSentencesThemselvesWhereNoLanguageIsChosen) {
    for (const char* const sentence : translatableErrors()) {
        const QString message = withNames(sentence);
        EXPECT_EQ(translatedError(message.toStdString()), message);
    }
    for (const char* const message :
         {"tooth.stl: the surface of layer 'pulp' is open (3 edges without a neighbour), so it has no inside to cut: "
          "close its holes first.",
          "Nobody has written this: not even so.", "a.b: %1 %2.", ": ", ".", ""}) {
        EXPECT_EQ(translatedError(message), QString(message));
    }
}

TEST_F(JapaneseErrorTranslation, EachSentenceIsTakenForItself) {
    for (const char* const sentence : translatableErrors()) {
        const QString translation = japanese_.translate("Error", sentence);
        ASSERT_FALSE(translation.isEmpty()) << sentence;
        EXPECT_EQ(translatedError(withNames(sentence).toStdString()), withNames(translation)) << sentence;
    }
}

TEST_F(JapaneseErrorTranslation, NamesStandInTheirPlaces) {
    EXPECT_EQ(translatedError("/home/a: b/tooth.stl: there is no such file; check the name and the folder."),
              QStringLiteral("/home/a: b/tooth.stl：ファイルがありません。名前とフォルダーを確かめてください。"));
    EXPECT_EQ(
        translatedError("a%2.stl: triangle 7 (byte 384) has a corner that is not a finite number; repair or export "
                        "the surface again."),
        QStringLiteral("a%2.stl：三角形 7（384 バイト目）の頂点が有限の数値ではありません。"
                       "表面を修復するか、書き出し直してください。"));
}

TEST_F(JapaneseErrorTranslation, SentencesWithinSentencesAreSaidToo) {
    EXPECT_EQ(
        translatedError("tooth.stl: layer 'pulp' lies outside the tooth: give all layers in the frame of the outer "
                        "surface."),
        QStringLiteral("tooth.stl：層「pulp」が歯の外側にあります。すべての層を外表面と同じ座標系にしてください。"));
    EXPECT_EQ(
        translatedError("a.stl, line 2: expected 'outer', but the file ends: it is cut short; repair or export the "
                        "surface again."),
        QStringLiteral("a.stl、2 行目：'outer' が必要です。ファイルが途中で切れています。"
                       "表面を修復するか、書き出し直してください。"));
    EXPECT_EQ(
        translatedError("OpenHaptics, the device 'Left': The device is in use: close the other program that holds "
                        "it."),
        QStringLiteral(
            "OpenHaptics、装置「Left」：装置は使用中です。装置を使っている他のプログラムを閉じてください。"));
}

TEST_F(JapaneseErrorTranslation, WhatNobodyHasTranslatedStaysAsItIs) {
    for (const char* const message : {"Nobody has written this.", "tooth.stl: nobody: has written this.", ": ", ""}) {
        EXPECT_EQ(translatedError(message), QString(message));
    }
}

TEST_F(JapaneseErrorTranslation, FailuresOfTheLibrariesHaveATranslation) {
    expectSaid(readFile("/no/such/tooth.stl").error().message);
    expectSaid(readFile("/").error().message);
    expectSaid(checkDeviceName("x", "--device").error().message);
    TriangleMesh open = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    open.triangles.pop_back();
    const auto tooth = LayeredTooth::make(open, {});
    ASSERT_FALSE(tooth);
    EXPECT_EQ(translatedError("a.stl: " + tooth.error().message),
              QStringLiteral("a.stl：歯の表面が閉じておらず（隣のない辺 3 本）、削る内部がありません。"
                             "先に穴をふさいでください"));
    const auto materials = parseMaterials("[enamel]\ncolour = [1, 2]\n", "m.toml");
    ASSERT_FALSE(materials);
    EXPECT_EQ(translatedError(materials.error().message),
              QStringLiteral("m.toml、2 行目：'colour' は角括弧で囲んだ三つの数値（赤、緑、青）でなければなりません"
                             "（実際の値：要素 2 個のリスト）。"));
}

TEST_F(JapaneseErrorTranslation, EachTroubleOfAPenHasATranslation) {
    for (std::uint32_t code = 0; code < 0x1000; ++code) expectSaid(hdErrorText(code));
}

TEST_F(JapaneseErrorTranslation, EachTroubleOfAnInverse3HasATranslation) {
    for (const char* const lack : {"power_supply", "calibrated", "ready"}) {
        const std::string message = R"({"version":"3.1","inverse3":[{"device_id":"049D","status":{")" +
                                    std::string(lack) +
                                    R"(":false},"state":{"cursor_position":{"x":0.01,"y":0.02,"z":0.1}}}]})";
        const Expected<HaplyReading> reading = readHaply(message, {"049D", ""});
        ASSERT_TRUE(reading) << reading.error().message;
        ASSERT_NE(reading->faultMessage, nullptr) << lack;
        expectSaid(reading->faultMessage);
    }
    const Expected<HaplyReading> nowhere = readHaply(
        R"({"version":"3.1","inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":null}}}]})", {"049D", ""});
    ASSERT_TRUE(nowhere) << nowhere.error().message;
    ASSERT_NE(nowhere->faultMessage, nullptr);
    expectSaid(nowhere->faultMessage);
    for (const char* const text : {"", "{}"}) {
        const Expected<HaplyReading> none = readHaply(text, {"049D", ""});
        ASSERT_FALSE(none);
        expectSaid(none.error().message);
    }
}

TEST_F(JapaneseErrorTranslation, AHandThatCannotBeThereHasATranslation) {
    for (const PoseFault fault : {PoseFault::NotANumber, PoseFault::InvalidRotation, PoseFault::Jump,
                                  PoseFault::TooFast, PoseFault::RotatesTooFast, PoseFault::Stale, PoseFault::Force}) {
        PoseMonitor monitor;
        monitor.update(fault, 0.001);
        ASSERT_NE(monitor.faultMessage(), nullptr);
        expectSaid(monitor.faultMessage());
    }
}

}  // namespace
}  // namespace tactooth

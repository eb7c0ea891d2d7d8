// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an examination forbids and hides, what it records, and what comes back when it is finished.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <filesystem>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "assessment/exercise.h"
#include "session/recording/recording_seal.h"
#include "session/recording/station_key.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

}  // namespace

class WindowExaminationTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void itBeginsOnlyWithAToothThatNobodyHasTouched();
    void itHidesNumbersTargetAndHistory();
    void nothingIsMeasured();
    void anotherToothCanBeTakenUntilItIsTouched();
    void anExerciseAllowsOnlyItsInstruments();
    void nothingIsTakenBack();
    void noOtherToothAndNoReplayOnceItIsTouched();
    void theSettingsKeepThePanelsOfBefore();
    void finishingShowsAllAgainAndSignsTheRecording();
    void cleanupTestCase();

private:
    [[nodiscard]] QAction& entry() const { return *window_->findChild<QAction*>("examination"); }
    [[nodiscard]] QDockWidget& dock(const QString& title) const {
        for (QDockWidget* each : window_->findChildren<QDockWidget*>()) {
            if (each->windowTitle() == title) return *each;
        }
        qFatal("no such dock");
    }
    [[nodiscard]] QLabel& fact(const QString& name) const {
        for (QLabel* label : window_->findChildren<QLabel*>()) {
            if (label->accessibleName() == name) return *label;
        }
        qFatal("no such fact");
    }
    [[nodiscard]] QString hint() const { return window_->findChild<QLabel*>("hint")->text(); }
    [[nodiscard]] std::vector<fs::path> recordings() const {
        std::vector<fs::path> files;
        for (const auto& file : fs::directory_iterator(folder_ / "recordings")) files.push_back(file.path());
        return files;
    }

    std::string docksBefore_;
    double cut_ = 0;
    bool measuredBefore_ = false;
};

void WindowExaminationTest::initTestCase() {
    qputenv("XDG_DATA_HOME", (folder_ / "data").c_str());
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
}

void WindowExaminationTest::cleanupTestCase() { closeWindow(); }

void WindowExaminationTest::itBeginsOnlyWithAToothThatNobodyHasTouched() {
    QVERIFY(!window_->examination().isOn());
    cutALittle();
    entry().trigger();
    QVERIFY(dismissMessage().contains("nobody has touched"));
    QVERIFY(!window_->examination().isOn());
    QVERIFY(!fs::exists(stationKeyFile()));
    loadMolar();
    docksBefore_ = window_->settings().docks;
    key(Qt::Key_I);
    measuredBefore_ = view().measureTool().isOn();
    entry().trigger();
    QVERIFY(window_->examination().isOn());
    QVERIFY(entry().text().startsWith("Finish"));
    QVERIFY(fs::exists(stationKeyFile()));
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().isSealing(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QLabel*>("recordingSign")->text().contains("signed"), kPatience);
}

void WindowExaminationTest::itHidesNumbersTargetAndHistory() {
    for (const char* title : {"Force", "Look inside", "Last ten seconds", "What happened", "History"}) {
        QVERIFY2(!dock(title).isVisible(), title);
        QVERIFY2(!dock(title).toggleViewAction()->isEnabled(), title);
    }
    dock("Exercise").raise();
    for (const char* name : {"Overlap (Dice)", "enamel removed"}) QVERIFY2(fact(name).isHidden(), name);
    QVERIFY(!fact("Time").isHidden());
    QVERIFY(window_->findChild<QProgressBar*>("cleared")->isHidden());
    QVERIFY(window_->findChild<QLabel*>("removed")->isHidden());
    QVERIFY(window_->findChild<DialGauge*>("forceGauge")->isHidden());
    QVERIFY(!window_->findChild<DialGauge*>("speedGauge")->isHidden());
    for (const char* name : {"startAgain", "exportReport"}) {
        QVERIFY2(!window_->findChild<QToolButton*>(name)->isEnabled(), name);
    }
    QVERIFY(!window_->recordings().findChild<QAction*>("recordSessions")->isEnabled());
}

void WindowExaminationTest::nothingIsMeasured() {
    QVERIFY(measuredBefore_);
    QVERIFY(!view().measureTool().isOn());  // it ended with the begin of the examination
    for (const char* name : {"distance", "angle"}) {
        QVERIFY2(!window_->findChild<QAction*>(name)->isEnabled(), name);
        window_->findChild<QAction*>(name)->trigger();
    }
    key(Qt::Key_I);
    QTest::keyClick(&view(), Qt::Key_I, Qt::ShiftModifier);
    view().measureTool().setKind(MeasureKind::Distance);
    QVERIFY(!view().measureTool().isOn());
    QVERIFY(view().measureTool().overlay().isHidden());
}

void WindowExaminationTest::anotherToothCanBeTakenUntilItIsTouched() {
    auto* choice = window_->findChild<QComboBox*>("exercise");
    dock("Exercise").raise();
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("Pit in the molar"), kLoadPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().targetState().target.metrics != nullptr, kLoadPatience);
    waitForSteps(3);
    const auto* ghost = window_->findChild<QCheckBox*>("ghost");
    QVERIFY(!ghost->isChecked() && !ghost->isEnabled());
    key(Qt::Key_G);
    QVERIFY(!ghost->isChecked());
    QVERIFY(window_->model().isSealing());
    QTRY_VERIFY_WITH_TIMEOUT(view().aim().lines().empty(), kPatience);
}

void WindowExaminationTest::anExerciseAllowsOnlyItsInstruments() {
    const auto load = [this](const std::shared_ptr<const Exercise>& exercise) {
        window_->exercise().start(exercise);
        QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() == exercise, kLoadPatience);
        waitForTooth();
        QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().targetState().target.metrics != nullptr, kLoadPatience);
    };
    const auto pit = builtinExercise("pit-46");
    auto strict = std::make_shared<Exercise>(*pit);
    strict->onlyTheseBurs = true;
    strict->instruments = {HandpieceKind::Turbine};
    load(strict);
    QVERIFY(window_->examination().isOn());
    auto* drill = window_->findChild<DrillBar*>();
    drill->choose("57", {});
    key(Qt::Key_F6);
    waitForTooth();
    QCOMPARE(drill->burNumber(), QString("330"));
    QVERIFY(!window_->model().bur()->isHandInstrument());
    load(pit);
    drill->choose("57", {});
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().bur()->name, findBur("57")->name, kPatience);
    waitForTooth();
    load(pit);
}

void WindowExaminationTest::nothingIsTakenBack() {
    cutALittle();
    cut_ = removed();
    QVERIFY(window_->model().isTouched());
    const auto* bar = window_->findChild<DrillBar*>();
    for (QAction* action : bar->actions()) {
        if (action->objectName() == "undo" || action->objectName() == "redo") QVERIFY(!action->isEnabled());
    }
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_R, Qt::ControlModifier);
    window_->model().goTo(0);
    for (QAction* menu : window_->menuBar()->actions()) {
        for (QAction* action : menu->menu()->actions()) {
            if (action->text().contains("demonstration") || action->text().contains("Reset tooth")) action->trigger();
        }
    }
    waitForSteps(20);
    waitForCarving();
    QCOMPARE(removed(), cut_);
}

void WindowExaminationTest::noOtherToothAndNoReplayOnceItIsTouched() {
    const CutModel* const piece = window_->model().tooth()->piece.get();
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    QVERIFY(unsavedQuestion() == nullptr);
    QVERIFY(hint().contains("examination"));
    auto* choice = window_->findChild<QComboBox*>("exercise");
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Up);
    QVERIFY(choice->currentText().contains("Pit in the molar"));
    window_->replay().open("any.ttsession");
    QVERIFY(!window_->replay().isLoading());
    waitForSteps(5);
    QVERIFY(window_->model().tooth()->piece.get() == piece);
    QCOMPARE(removed(), cut_);
}

void WindowExaminationTest::theSettingsKeepThePanelsOfBefore() {
    QCOMPARE(window_->settings().docks, docksBefore_);
    QVERIFY(window_->settings().recordsSessions);
}

void WindowExaminationTest::finishingShowsAllAgainAndSignsTheRecording() {
    entry().trigger();
    auto* question = window_->findChild<QMessageBox*>("finishExamination");
    QVERIFY(question != nullptr);
    QTest::keyClick(question, Qt::Key_Escape);
    QVERIFY(window_->examination().isOn());
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>("finishExamination") == nullptr, kPatience);
    entry().trigger();
    question = window_->findChild<QMessageBox*>("finishExamination");
    for (QAbstractButton* button : question->buttons()) {
        if (question->buttonRole(button) == QMessageBox::AcceptRole) QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(!window_->examination().isOn());
    for (const char* title : {"Force", "Look inside", "History"})
        QVERIFY2(dock(title).toggleViewAction()->isEnabled(), title);
    QVERIFY(!dock("Look inside").isHidden());
    for (const char* name : {"distance", "angle"}) QVERIFY2(window_->findChild<QAction*>(name)->isEnabled(), name);
    QVERIFY(!fact("enamel removed").isHidden());
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QCheckBox*>("ghost")->isChecked(), kPatience);
    QVERIFY(!window_->model().isRecording());

    int sealed = 0;
    for (const fs::path& file : recordings()) {
        const auto recording = SessionRecording::open(file);
        QVERIFY(recording.has_value());
        if (!recording->facts().isSealed) continue;
        ++sealed;
        const auto seal = checkRecordingSeal(*recording, knownStationKey());
        QVERIFY(seal.has_value() && seal->verdict == SealReport::Verdict::Intact);
        int edits = 0;
        QVERIFY(recording
                    ->forEach([&](const SessionEvent& event) {
                        edits += std::holds_alternative<EditEvent>(event) ? 1 : 0;
                        return true;
                    })
                    .has_value());
        QCOMPARE(edits, 0);
        QVERIFY(*recording->hasChanges());
    }
    QCOMPARE(sealed, 1);
    waitForTooth();
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowExaminationTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_examination_test.moc"

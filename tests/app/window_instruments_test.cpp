// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tray of instruments: what is taken from it is in the hand, undone, kept with the work and recorded.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QMenu>
#include <QToolButton>

#include "app/gui/keys/key_binding.h"
#include "app/gui/model/current_work.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/instrument_tray.h"
#include "app/gui/scene/aim_overlay.h"
#include "app/gui/scene/session_scene.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/settings/window_style.h"
#include "app/gui/text/translation.h"
#include "app/window_session.h"
#include "assessment/exercise.h"

namespace tactooth {

class WindowInstrumentsTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void eachInstrumentHasAPictureAKeyAndAPlaceInTheMenu();
    void aKeyAndAClickTakeAnInstrument();
    void aHandInstrumentHasNoHandpieceAndDoesNotTurn();
    void theHandpieceComesBackWithItsBur();
    void takingAnInstrumentIsUndone();
    void theExplorerAndTheProbeTouchWithTheForceThatIsSet();
    void theWorkKeepsTheInstrument();
    void anExerciseAllowsOnlyItsInstruments();
    void cleanupTestCase();

private:
    [[nodiscard]] InstrumentTray& tray() const { return *window_->findChild<InstrumentTray*>("instrumentTray"); }
    [[nodiscard]] QAction& action(const QString& name) const { return *window_->findChild<QAction*>("take-" + name); }
    [[nodiscard]] std::optional<HandInstrument> held() const { return window_->model().bur()->instrument.hand; }
    void take(const char* name, HandInstrument kind);
};

void WindowInstrumentsTest::initTestCase() {
    openWindowWithSettings();
    waitForTooth();
}

void WindowInstrumentsTest::cleanupTestCase() { closeWindow(); }

void WindowInstrumentsTest::take(const char* name, HandInstrument kind) {
    action(name).trigger();
    waitForTooth();
    QCOMPARE(held(), std::optional(kind));
    QVERIFY(action(name).isChecked());
}

void WindowInstrumentsTest::eachInstrumentHasAPictureAKeyAndAPlaceInTheMenu() {
    QTRY_VERIFY_WITH_TIMEOUT(!tray().isDrawing(), kPatience);
    std::vector<QImage> pictures;
    QList<QAction*> instruments;
    for (QAction* one : tray().actions()) {
        if (one->isSeparator()) continue;
        instruments << one;
        QVERIFY2(!one->shortcut().isEmpty(), qPrintable(one->text()));
        QVERIFY2(one->toolTip().contains(one->shortcut().toString()), qPrintable(one->toolTip()));
        pictures.push_back(one->icon().pixmap(tray().iconSize()).toImage());
        QVERIFY(tray().widgetForAction(one)->focusPolicy() & Qt::TabFocus);  // the gamepad and the Tab key reach it
    }
    QCOMPARE(instruments.size(), 6);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) QVERIFY(pictures[i] != pictures[j]);
    }
    const auto* menu = window_->findChild<QMenu*>("instruments");
    for (QAction* one : instruments) QVERIFY(menu->actions().contains(one));
}

void WindowInstrumentsTest::aKeyAndAClickTakeAnInstrument() {
    key(Qt::Key_F6);
    waitForTooth();
    QCOMPARE(held(), std::optional(HandInstrument::Probe));
    QTest::mouseClick(tray().widgetForAction(&action("explorer")), Qt::LeftButton);
    waitForTooth();
    QCOMPARE(held(), std::optional(HandInstrument::Explorer));
    QVERIFY(action("explorer").isChecked());
    QVERIFY(!action("probe").isChecked());
    key(Qt::Key_F2);
    waitForTooth();
    QVERIFY(!held());
}

void WindowInstrumentsTest::aHandInstrumentHasNoHandpieceAndDoesNotTurn() {
    take("excavator", HandInstrument::Excavator);
    const SceneContents contents = sceneContents(window_->model(), true, false);
    QVERIFY(contents.tool->turbine == nullptr);
    QVERIFY(contents.tool->bur == window_->model().bur()->shown);
    key(Qt::Key_C);
    view().setFocus();
    QTest::keyPress(&view(), Qt::Key_Space);
    waitForSteps(30);
    QCOMPARE(window_->model().log().newest().spindle.speedRpm, 0.0);
    QCOMPARE(window_->model().log().newest().input.pedal, 0.0);
    QVERIFY(window_->model().animation().particles().empty());
    QTest::keyRelease(&view(), Qt::Key_Space);
    key(Qt::Key_T);
}

void WindowInstrumentsTest::theHandpieceComesBackWithItsBur() {
    window_->teeth().loadBur(*findBur("245"));
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().bur()->name, findBur("245")->name, kPatience);
    waitForTooth();
    take("probe", HandInstrument::Probe);
    QCOMPARE(window_->findChild<QComboBox*>("burs")->currentData().toString(), QString("245"));
    key(Qt::Key_F4);
    waitForTooth();
    QCOMPARE(window_->model().bur()->name, findBur("245")->name);
    QCOMPARE(window_->model().haptics().spindle.name, spindlePresets()[2].name);
    key(Qt::Key_F2);
    waitForTooth();
    QCOMPARE(window_->model().haptics().spindle.name, spindlePresets()[0].name);
}

void WindowInstrumentsTest::takingAnInstrumentIsUndone() {
    take("explorer", HandInstrument::Explorer);
    const auto newest = [this] {
        const auto& steps = window_->model().history().steps();
        return steps.empty() ? QString() : translated(steps.back().name);
    };
    QTRY_VERIFY2_WITH_TIMEOUT(newest().contains("Explorer"), qPrintable(newest()), kPatience);
    window_->model().undo();
    QTRY_VERIFY_WITH_TIMEOUT(!held(), kPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(!action("explorer").isChecked(), kPatience);
    window_->model().redo();
    QTRY_COMPARE_WITH_TIMEOUT(held(), std::optional(HandInstrument::Explorer), kPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(action("explorer").isChecked(), kPatience);
}

void WindowInstrumentsTest::theExplorerAndTheProbeTouchWithTheForceThatIsSet() {
    for (const auto& [name, kind] :
         {std::pair("explorer", HandInstrument::Explorer), std::pair("probe", HandInstrument::Probe)}) {
        take(name, kind);
        pressBurOn(middle());
        QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
        const double wanted = window_->model().manipulator().pressDepth();
        QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.depth > 0.7 * wanted, kPatience);
        const auto lines = [this] { return window_->findChild<AimOverlay*>()->lines().join('\n'); };
        QTRY_VERIFY2_WITH_TIMEOUT(lines().contains("Force"), qPrintable(lines()), kPatience);
        QVERIFY2(!lines().contains("pulp"), qPrintable(lines()));
        liftBur(middle());
        QCOMPARE(removed(), 0.0);
    }
}

void WindowInstrumentsTest::theWorkKeepsTheInstrument() {
    take("probe", HandInstrument::Probe);
    const SessionWork work = currentWork(window_->model(), nullptr, {});
    const std::optional<SessionBur> again = burOf(work, {});
    QVERIFY(again.has_value());
    QCOMPARE(again->instrument.hand, std::optional(HandInstrument::Probe));
    key(Qt::Key_F2);
    waitForTooth();
}

/// By no way: a key, a click, the list of drives, or what comes from elsewhere.
void WindowInstrumentsTest::anExerciseAllowsOnlyItsInstruments() {
    QCOMPARE(window_->model().haptics().spindle.name, spindlePresets()[0].name);
    Exercise strict = *builtinExercise("pit-46");
    strict.instruments = {HandpieceKind::LowSpeed, HandInstrument::Excavator};
    window_->exercise().start(std::make_shared<const Exercise>(strict));
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    const auto drive = [this] { return window_->model().haptics().spindle.name; };
    QCOMPARE(drive(), spindlePresets()[2].name);
    QTRY_VERIFY_WITH_TIMEOUT(action(QString::fromStdString(spindlePresets()[2].name)).isChecked(), kPatience);
    applyKeys(*window_, KeyMap());  // as after each change of a key
    int allowed = 0;
    for (QAction* one : tray().actions()) {
        if (one->isSeparator()) continue;
        const bool isAllowed =
            one == &action("excavator") || one == &action(QString::fromStdString(spindlePresets()[2].name));
        QCOMPARE(one->isEnabled(), isAllowed);
        QCOMPARE(one->toolTip().contains("This exercise does not allow this instrument"), !isAllowed);
        QVERIFY2(one->toolTip().contains(one->shortcut().toString()), qPrintable(one->toolTip()));
        allowed += isAllowed ? 1 : 0;
    }
    QCOMPARE(allowed, 2);
    key(Qt::Key_F2);
    key(Qt::Key_F6);
    window_->findChild<DrillBar*>()->choose({}, QString::fromStdString(spindlePresets()[1].name));
    waitForTooth();
    QVERIFY(!held());
    QCOMPARE(drive(), spindlePresets()[2].name);
    take("excavator", HandInstrument::Excavator);
    key(Qt::Key_F4);
    waitForTooth();
    QVERIFY(!held());
    window_->model().install(makeHandInstrument(HandInstrument::Probe));  // as an undone change brings it
    QVERIFY(held().has_value());
    QTRY_VERIFY_WITH_TIMEOUT(!held(), kPatience);
    waitForTooth();

    window_->exercise().start(nullptr);  // free practice allows all
    for (QAction* one : tray().actions()) {
        QVERIFY(one->isSeparator() || (one->isEnabled() && !one->toolTip().contains("allow")));
    }
    key(Qt::Key_F2);
    waitForTooth();
    QCOMPARE(drive(), spindlePresets()[0].name);
    loadMolar();
}

void WindowInstrumentsTest::savePictures(const QString& folder) {
    initTestCase();
    QTRY_VERIFY_WITH_TIMEOUT(!tray().isDrawing(), kPatience);
    for (const bool dark : {false, true}) {
        applyColours(dark);
        const QString end = dark ? "-dark.png" : ".png";
        for (const HandInstrumentSpec& spec : handInstruments()) {
            action(QString::fromStdString(std::string(spec.name))).trigger();
            waitForTooth();
            pressBurOn(middle());
            QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
            QVERIFY(waitForQuietPicture());
            window_->grab().save(folder + "/instrument-" + QString::fromStdString(std::string(spec.name)) + end);
            liftBur(middle());
        }
        tray().grab().save(folder + "/instrument-tray" + end);
    }
    applyColours(false);
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_instruments_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowInstrumentsTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_instruments_test.moc"

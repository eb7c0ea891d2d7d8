// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A whole session with a gamepad alone in the real window: no mouse and no key is touched.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QThread>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>

#include "app/gui/dialogs/text_dialog.h"
#include "app/gui/dialogs/welcome_dialog.h"
#include "app/gui/panels/elided_label.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "devices/sdl/joysticks.h"
#include "devices/virtual_pad.h"
#include "track/recorded_strokes.h"

namespace tactooth {
namespace {

constexpr double kLift = 2;  // mm, clear of the tooth
constexpr const char* kPad = "Test Pad";

}  // namespace

class PadSessionTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void theWelcomeIsAnsweredByThePad();
    void theToothIsTouchedWithinHalfAMinute();
    void theToothIsCut();
    void theMenuTakesTheCutBack();
    void aMenuShowsTheToothFromAbove();
    void whileAMenuIsOpenTheToolStaysAndNothingToggles();
    void pressesThatComeAtOnceAreEachFollowed();
    void startClosesMenusAndBackLeavesPanels();
    void anArrowThatIsHeldGoesOn();
    void thePadTurnsShiftsAndEnlargesThePicture();
    void anotherBurIsTakenInTheDrillBar();
    void aParameterIsChangedInAPanel();
    void aDialogIsReadAndLeft();
    void aFileIsAskedForByADialogThatThePadReaches();
    void twoRecordingsAreComparedByThePad();
    void withTheMouseThePadOpensNothing();
    void cleanupTestCase();

private:
    void press(SDL_GameControllerButton button, int times = 1);
    void setButton(SDL_GameControllerButton button, bool isDown) const;
    void waitForPad() const;
    void pressAndSee(SDL_GameControllerButton button, const std::function<bool()>& seen);
    void holdUntil(SDL_GameControllerButton button, const std::function<bool()>& done);
    void stick(SDL_GameControllerAxis axis, double value) { pad_->axis(axis, value); }
    void liftOff();
    void choose(const QAction* entry);
    [[nodiscard]] static QMenu* menu() { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); }
    [[nodiscard]] QAction* entry(const QString& text) const;
    [[nodiscard]] Pose tool() const { return window_->model().log().newest().input.device; }
    [[nodiscard]] bool isCutting() const { return window_->model().log().newest().input.cutting; }
    [[nodiscard]] QString hint() const { return window_->findChild<ElidedLabel*>("hint")->text(); }

    std::unique_ptr<test::VirtualPad> pad_;
    std::weak_ptr<SdlJoysticks> joysticks_;  // of the program, as long as it uses the pad
    QElapsedTimer sinceOpened_;
    std::clock_t processorAtOpening_ = 0;
};

void PadSessionTest::press(SDL_GameControllerButton button, int times) {
    for (int i = 0; i < times; ++i) {
        setButton(button, true);
        waitForPad();
        setButton(button, false);
        waitForPad();
    }
}

/// Returns as soon as the program has read it, which it does each 4 ms, on a busy machine more rarely. The window waits
/// meanwhile, so that a held arrow does not go on.
void PadSessionTest::setButton(SDL_GameControllerButton button, bool isDown) const {
    pad_->button(button, isDown);
    const auto joysticks = joysticks_.lock();
    if (joysticks == nullptr) return;  // the program reads no pad
    const auto isRead = [&] {
        for (const JoystickState& each : joysticks->states()) {
            if (each.name == kPad) return each.buttons.at(static_cast<std::size_t>(button)) == isDown;
        }
        return false;
    };
    QElapsedTimer since;
    for (since.start(); !isRead() && since.elapsed() < kPatience;) QThread::msleep(1);
    QVERIFY(isRead());
}

/// Until the window has made a step with what the program has read.
void PadSessionTest::waitForPad() const { waitForSteps(2); }

/// Presses and waits until the effect is visible, at most some seconds: then the press seems lost.
void PadSessionTest::pressAndSee(SDL_GameControllerButton button, const std::function<bool()>& seen) {
    press(button);
    (void)QTest::qWaitFor(seen, 5000);
}

/// Holds the button until the effect is visible, as a user does: a busy machine draws late.
void PadSessionTest::holdUntil(SDL_GameControllerButton button, const std::function<bool()>& done) {
    pad_->button(button, true);
    const bool isDone = QTest::qWaitFor(done, kPatience);
    setButton(button, false);
    QVERIFY(isDone);
    waitForPad();
}

void PadSessionTest::liftOff() {
    stick(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -1);
    stick(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    stick(SDL_CONTROLLER_AXIS_LEFTX, 0);
    const double height = tool().position.z();
    holdUntil(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, [&] { return tool().position.z() > height + kLift; });
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().log().newest().contact.triangles, 0U, kPatience);
}

QAction* PadSessionTest::entry(const QString& text) const {
    for (QAction* each : window_->findChildren<QAction*>()) {
        if (each->text() == text) return each;
    }
    return nullptr;
}

/// Moves through the menus as a user does: to the right until the entry is visible, then down to it.
void PadSessionTest::choose(const QAction* entry) {
    QVERIFY(entry != nullptr);
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, kPatience);
    const auto isSeen = [entry] { return menu() != nullptr && menu()->actions().contains(entry); };
    for (int i = 0; i < 16 && !isSeen(); ++i) {
        pressAndSee(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, [before = menu()] { return menu() != before; });
    }
    QVERIFY(isSeen());
    for (int i = 0; i < 40 && isSeen() && menu()->activeAction() != entry; ++i) {
        pressAndSee(SDL_CONTROLLER_BUTTON_DPAD_DOWN, [before = menu()->activeAction()] {
            return menu() == nullptr || menu()->activeAction() != before;
        });
    }
    QVERIFY(isSeen());
    QCOMPARE(menu()->activeAction(), entry);
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(menu() == nullptr, kPatience);
}

void PadSessionTest::initTestCase() {
    pad_ = std::make_unique<test::VirtualPad>(kPad);
    stick(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -1);
    stick(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    sinceOpened_.start();
    processorAtOpening_ = std::clock();
    openWindow();
    WindowSettings settings = window_->settings();
    settings.hand.device = "gamepad";
    window_->apply(settings);
    window_->welcome().open();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().devices().first() != nullptr, kPatience);
    if (auto joysticks = SdlJoysticks::shared()) joysticks_ = *joysticks;
    waitForTooth();
    QApplication::setActiveWindow(
        window_->findChild<WelcomeDialog*>());  // a bare X server has no window manager to do it
}

void PadSessionTest::theWelcomeIsAnsweredByThePad() {
    auto* dialog = window_->findChild<WelcomeDialog*>();
    QVERIFY(dialog != nullptr && dialog->isVisible());
    const Pose before = tool();
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    QTRY_COMPARE_WITH_TIMEOUT(dialog->focusWidget(), dialog->findChild<QPushButton*>("openMine"), kPatience);
    press(SDL_CONTROLLER_BUTTON_DPAD_UP);
    QTRY_COMPARE_WITH_TIMEOUT(dialog->focusWidget(), dialog->findChild<QPushButton*>("practise"), kPatience);
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<WelcomeDialog*>() == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isActiveWindow(), kPatience);  // otherwise Qt closes menus that open late
    waitForSteps(10);
    QVERIFY(!isCutting());
    QVERIFY((tool().position - before.position).norm() < 0.01);
    QTRY_VERIFY2_WITH_TIMEOUT(hint().contains("Start: menus"), qPrintable(hint()), kPatience);
}

/// The processor time shows what the program would take with two cores of its own.
void PadSessionTest::theToothIsTouchedWithinHalfAMinute() {
    stick(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0.2);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
    const double passed = static_cast<double>(sinceOpened_.elapsed()) / 1000;
    const double onTwoCores = static_cast<double>(std::clock() - processorAtOpening_) / CLOCKS_PER_SEC / 2;
    QVERIFY2(std::min(passed, onTwoCores) < 30, qPrintable(QString("%1 s, %2 s").arg(passed).arg(onTwoCores)));
    QCOMPARE(removed(), 0.0);
    liftOff();
}

void PadSessionTest::theToothIsCut() {
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(isCutting(), kPatience);
    stick(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().spindle.speedRpm > 200'000, kPatience);
    stick(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0.3);
    QElapsedTimer since;
    since.start();
    while (removed() < 0.02 && since.elapsed() < kPatience) {
        stick(SDL_CONTROLLER_AXIS_LEFTX, 0.3 * std::sin(1e-3 * static_cast<double>(since.elapsed()) * 6));
        QTest::qWait(30);
    }
    QVERIFY(removed() >= 0.02);
    liftOff();
}

void PadSessionTest::theMenuTakesTheCutBack() {
    const double before = removed();
    const bool cutting = isCutting();
    choose(entry("Undo"));
    QTRY_VERIFY_WITH_TIMEOUT(removed() < before, kPatience);
    QCOMPARE(isCutting(), cutting);  // button A was for the menu
}

void PadSessionTest::aMenuShowsTheToothFromAbove() {
    choose(entry("Occlusal"));
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(view().orbitCamera().direction().elevation - std::numbers::pi / 2) < 1e-6,
                             kPatience);
}

void PadSessionTest::whileAMenuIsOpenTheToolStaysAndNothingToggles() {
    waitForSteps(10);
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, kPatience);
    waitForSteps(10);
    const Pose before = tool();
    const bool cutting = isCutting();
    const OrbitCamera::Direction eye = view().orbitCamera().direction();
    stick(SDL_CONTROLLER_AXIS_LEFTX, 1);
    stick(SDL_CONTROLLER_AXIS_RIGHTY, 1);
    press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, 2);
    waitForSteps(10);
    stick(SDL_CONTROLLER_AXIS_LEFTX, 0);
    stick(SDL_CONTROLLER_AXIS_RIGHTY, 0);
    const auto moved = [&] { return (tool().position - before.position).norm(); };
    QVERIFY(menu() != nullptr);
    QVERIFY2(moved() < 0.01, qPrintable(QString("%1 mm with the menu open").arg(moved())));
    press(SDL_CONTROLLER_BUTTON_B);  // outside menus it takes the mirror
    QTRY_VERIFY_WITH_TIMEOUT(menu() == nullptr, kPatience);
    waitForSteps(10);
    QVERIFY2(moved() < 0.01, qPrintable(QString("%1 mm after it").arg(moved())));
    QVERIFY(tool().rotation.angularDistance(before.rotation) < 0.01);
    QCOMPARE(isCutting(), cutting);
    QCOMPARE(view().orbitCamera().direction().azimuth, eye.azimuth);
    // The pad moves the tool again, and it is still the turbine.
    stick(SDL_CONTROLLER_AXIS_LEFTX, 1);
    QTRY_VERIFY_WITH_TIMEOUT(moved() > 1, kPatience);
    stick(SDL_CONTROLLER_AXIS_LEFTX, 0);
}

/// A busy window receives several presses at once.
void PadSessionTest::pressesThatComeAtOnceAreEachFollowed() {
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, kPatience);
    const QList<QAction*> menus = window_->menuBar()->actions();
    QCOMPARE(menu()->menuAction(), menus[0]);
    for (int i = 0; i < 3; ++i) {
        setButton(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, true);
        QThread::msleep(40);  // blocks the window
        setButton(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, false);
        QThread::msleep(40);
    }
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr && menu()->menuAction() == menus[3], kPatience);
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() == nullptr, kPatience);
}

void PadSessionTest::startClosesMenusAndBackLeavesPanels() {
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, kPatience);
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN, 2);  // Built-in teeth
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr && menu()->title().contains("teeth"), kPatience);
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() == nullptr, kPatience);
    press(SDL_CONTROLLER_BUTTON_BACK);
    QTRY_VERIFY_WITH_TIMEOUT(hint().contains("B: back to the tooth"), kPatience);
    press(SDL_CONTROLLER_BUTTON_BACK);
    QTRY_VERIFY_WITH_TIMEOUT(hint().contains("Start: menus"), kPatience);
    QCOMPARE(window_->focusWidget(), &view());
}

void PadSessionTest::anArrowThatIsHeldGoesOn() {
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() != nullptr, kPatience);
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    const QAction* first = menu()->activeAction();
    pad_->button(SDL_CONTROLLER_BUTTON_DPAD_DOWN, true);
    QTRY_VERIFY_WITH_TIMEOUT(menu()->actions().indexOf(menu()->activeAction()) > 4, kPatience);
    pad_->button(SDL_CONTROLLER_BUTTON_DPAD_DOWN, false);
    QVERIFY(menu()->activeAction() != first);
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(menu() == nullptr, kPatience);
}

void PadSessionTest::thePadTurnsShiftsAndEnlargesThePicture() {
    view().resetView();
    const OrbitCamera before = view().orbitCamera();
    const Pose held = tool();
    holdUntil(SDL_CONTROLLER_BUTTON_DPAD_RIGHT,
              [&] { return before.direction().azimuth - view().orbitCamera().direction().azimuth > 0.2; });
    setButton(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, true);
    waitForPad();
    holdUntil(SDL_CONTROLLER_BUTTON_DPAD_UP,
              [&] { return (view().orbitCamera().target() - before.target()).norm() > 0.5; });
    setButton(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, false);
    holdUntil(SDL_CONTROLLER_BUTTON_RIGHTSTICK,
              [&] { return view().orbitCamera().distance() < 0.8 * before.distance(); });
    holdUntil(SDL_CONTROLLER_BUTTON_LEFTSTICK,
              [&] { return view().orbitCamera().distance() > 0.95 * before.distance(); });
    QVERIFY((tool().position - held.position).norm() < 0.01);
}

void PadSessionTest::anotherBurIsTakenInTheDrillBar() {
    const std::string before = window_->model().bur()->name;
    press(SDL_CONTROLLER_BUTTON_BACK);
    QTRY_COMPARE_WITH_TIMEOUT(window_->focusWidget()->objectName(), QString("burs"), kPatience);
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
    press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() == nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isBusy() && window_->model().bur()->name != before, kPatience);
}

void PadSessionTest::aParameterIsChangedInAPanel() {
    const auto isMotionScaling = [this] { return window_->focusWidget()->accessibleName() == "Motion scaling"; };
    const double before = window_->model().controls.motionScaling;
    for (int i = 0; i < 20 && !isMotionScaling(); ++i) {
        press(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER);
        for (int k = 0; k < 8 && !isMotionScaling(); ++k) press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    }
    QVERIFY(isMotionScaling());
    QVERIFY(!window_->focusWidget()->visibleRegion().isEmpty());  // it was behind another tab
    press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, 3);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().controls.motionScaling > before, kPatience);
    press(SDL_CONTROLLER_BUTTON_DPAD_LEFT, 3);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(window_->model().controls.motionScaling - before) < 1e-9, kPatience);
    press(SDL_CONTROLLER_BUTTON_B);
    QTRY_COMPARE_WITH_TIMEOUT(window_->focusWidget(), &view(), kPatience);
}

void PadSessionTest::aDialogIsReadAndLeft() {
    choose(entry("&Mouse and keys"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<TextDialog*>() != nullptr, kPatience);
    QVERIFY(window_->findChild<TextDialog*>()->text().contains("Start, Back"));
    press(SDL_CONTROLLER_BUTTON_B);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<TextDialog*>() == nullptr, kPatience);
}

void PadSessionTest::aFileIsAskedForByADialogThatThePadReaches() {
    choose(entry("&Save tooth…"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    QVERIFY(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
}

void PadSessionTest::twoRecordingsAreComparedByThePad() {
    for (const unsigned seed : {1U, 2U}) {
        (void)test::RecordedStrokes{.seconds = 2, .seed = seed, .resetAt = 99}.writeTo(
            folder_ / (std::to_string(seed) + ".ttsession"));
    }
    ReplayController& replay = window_->replay();
    replay.open(QString::fromStdString(folder_ / "1.ttsession"));
    QTRY_VERIFY_WITH_TIMEOUT(replay.isActive(), kLoadPatience);
    choose(&replay.comparison().sideBySideAction());
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    press(SDL_CONTROLLER_BUTTON_START);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
    replay.comparison().open(QString::fromStdString(folder_ / "2.ttsession"), ReplayComparison::Mode::SideBySide);
    QTRY_VERIFY_WITH_TIMEOUT(replay.comparison().isSideBySide(), kLoadPatience);
    constexpr double kStart = 0.5;  // s
    replay.cursor().setPlaying(false);
    replay.cursor().jumpTo(kStart);

    const auto azimuth = [this](const char* view) {
        return window_->findChild<ToothView*>(view)->orbitCamera().direction().azimuth;
    };
    const double before = azimuth("replayView");
    holdUntil(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, [&] { return before - azimuth("replayView") > 0.2; });
    QTRY_COMPARE_WITH_TIMEOUT(azimuth("replayOtherView"), azimuth("replayView"), kPatience);

    press(SDL_CONTROLLER_BUTTON_BACK);
    const auto isPlay = [this] { return window_->focusWidget()->objectName() == "replayPlay"; };
    for (int i = 0; i < 20 && !isPlay(); ++i) {
        press(SDL_CONTROLLER_BUTTON_LEFTSHOULDER);
        for (int k = 0; k < 3 && !isPlay(); ++k) press(SDL_CONTROLLER_BUTTON_DPAD_DOWN);
    }
    QVERIFY(isPlay());
    press(SDL_CONTROLLER_BUTTON_A);
    QTRY_VERIFY_WITH_TIMEOUT(replay.cursor().time() > kStart, kPatience);  // it may have ended already
    press(SDL_CONTROLLER_BUTTON_B);
    QTRY_COMPARE_WITH_TIMEOUT(window_->focusWidget()->objectName(), QString("replayView"), kPatience);
    replay.leave();
    QTRY_VERIFY_WITH_TIMEOUT(view().isVisible() && window_->model().runner() != nullptr, kPatience);
    view().setFocus();
}

void PadSessionTest::withTheMouseThePadOpensNothing() {
    window_->devices().openFirst("mouse");
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().devices().first() == nullptr, kPatience);
    press(SDL_CONTROLLER_BUTTON_START);
    waitForSteps(10);
    QVERIFY(menu() == nullptr);
    QVERIFY(!window_->model().controls.clutch);
}

void PadSessionTest::cleanupTestCase() {
    closeWindow();
    pad_.reset();
}

}  // namespace tactooth

int main(int argc, char** argv) {
    setenv("TACTOOTH_DEVICE_IN_PROCESS", "1", 1);  // the virtual pad is in this process
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::PadSessionTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "pad_session_test.moc"

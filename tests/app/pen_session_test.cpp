// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A whole session with a haptic pen in the real window: the pen is a stand-in for the vendor's library, with a hand on
// a spring inside. $TACTOOTH_SESSION_SECONDS: how long it cuts (default: 3).
#include <dlfcn.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <cstdlib>

#include "app/device_session.h"
#include "app/gui/settings/window_setup.h"
#include "devices/standin/pen_folder.h"
#include "devices/standin/standin_hd.h"

namespace tactooth {

using test::HdFault;

class PenSessionTest : public test::DeviceSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { setFault(0); }
    void aMouseHasNoWorkspaceToFit();
    void eachHandMayChooseAPenByItsName();
    void anUncalibratedPenAsksForItsInkwell();
    void thePenTouchesTheTooth() { touchTheTooth(); }
    void itsBlueButtonCutsAndThePedalTurnsTheBur();
    void itsWhiteButtonTakesTheMirror() { takeTheMirrorByButton(0); }
    void theClutchHoldsTheBur();
    void fitToTheToothItIsFinerAndMovesNothing();
    void atTheWorkspaceLimitTheClutchIsNamed();
    void theOtherPenHoldsTheMirror();
    void eachFaultMidPressIsSaidAndKeepsTheSession_data();
    void eachFaultMidPressIsSaidAndKeepsTheSession();
    void backToTheMouseThePenIsClosedAndLimp();
    void aPenThatIsNotThereLeavesTheMouseAndSaysWhatToDo();
    void aDeviceThatFailsAtTheStartIsTriedAgainNextTime();
    void cleanupTestCase() { closeWindow(); }

private:
    /// Up is +y in the driver's frame.
    void moveHand(double right, double up) const override { standin_->wantPosition(right, up, 0); }
    void setButtons(unsigned down) const override { standin_->setButtons(static_cast<int>(down)); }
    [[nodiscard]] double force() const override { return standin_->forceOf(0); }
    [[nodiscard]] long exchanges() const override { return standin_->ticks(); }
    void setFault(int fault) const override { standin_->setFault(fault); }
    [[nodiscard]] long lastForceSinceFault() const override { return standin_->lastForceSinceFault(); }

    [[nodiscard]] QCheckBox& fit() const { return *window_->findChild<QCheckBox*>("fitMotionScaling"); }
    [[nodiscard]] QDoubleSpinBox& motionScaling() const;

    const test::HdStandinControl* standin_ = nullptr;
};

namespace {

constexpr double kMaxForce = 3.3;  // N, the limit of the stand-in

const test::HdStandinControl* standin() {
    return static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
}

}  // namespace

void PenSessionTest::initTestCase() {
    standin_ = standin();
    QVERIFY(standin_ != nullptr);
    openWindow();
    waitForTooth();
    QVERIFY(state().contains("mouse"));
}

QDoubleSpinBox& PenSessionTest::motionScaling() const {
    for (QDoubleSpinBox* box : window_->findChildren<QDoubleSpinBox*>()) {
        if (box->accessibleName() == "Motion scaling") return *box;
    }
    qFatal("the window has no motion scaling");
}

void PenSessionTest::aMouseHasNoWorkspaceToFit() {
    const auto* note = window_->findChild<QLabel*>("fitNote");
    QVERIFY(note->isHidden());
    fit().setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(!note->isHidden() && note->text().contains("1 : 1"), kPatience);
    QVERIFY(!motionScaling().isEnabled());
    fit().setChecked(false);
    QTRY_VERIFY_WITH_TIMEOUT(note->isHidden(), kPatience);
    QVERIFY(motionScaling().isEnabled());
    QCOMPARE(motionScaling().value(), 1.0);
}

void PenSessionTest::eachHandMayChooseAPenByItsName() {
    for (const char* list : {"devices", "secondDevices"}) {
        const auto* devices = window_->findChild<QComboBox*>(list);
        const int place = devices->findData("pen");
        QCOMPARE(devices->itemData(place + 1), QVariant("pen:Left"));
        QCOMPARE(devices->itemText(place + 1), QString("Haptic pen Left"));
        QCOMPARE(devices->itemData(place + 2), QVariant("pen:Right"));
        QCOMPARE(devices->itemData(place + 3), QVariant("inverse3"));
    }
}

void PenSessionTest::anUncalibratedPenAsksForItsInkwell() {
    standin_->setFault(static_cast<int>(HdFault::NeedsInkwell));
    chooseDevice("devices", "pen");
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().devices().first() != nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(state().contains("inkwell"), kPatience);
    QCOMPARE(force(), 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(hint().contains("inkwell"), kPatience);
    standin_->setFault(static_cast<int>(HdFault::None));
    QTRY_VERIFY_WITH_TIMEOUT(!state().contains("inkwell") && !hint().contains("inkwell"), kPatience);
    QCOMPARE(dismissMessages(), QString());  // a message would stop the hand at work
    QVERIFY2(state().contains("Touch (stand-in)"), qPrintable(state()));
}

void PenSessionTest::itsBlueButtonCutsAndThePedalTurnsTheBur() {
    const char* const seconds = std::getenv("TACTOOTH_SESSION_SECONDS");
    cutByButtonAndPedal(1, seconds != nullptr ? std::atof(seconds) : 3);
    QVERIFY(standin_->strongestForce() <= kMaxForce);
}

void PenSessionTest::theClutchHoldsTheBur() {
    const Vec3 tool = toolTip();
    auto* clutch = window_->findChild<QPushButton*>("clutch");
    (void)dismissMessages();  // a device that a busy machine has stalled may have one; it takes all keys
    key(Qt::Key_X);           // works behind another tab too
    QVERIFY(clutch->isChecked());
    waitUntilRead();
    moveHand(0, 4);
    waitForHand();
    QVERIFY((toolTip() - tool).norm() < 0.5);
    clutch->setChecked(false);
    waitUntilRead();
    QVERIFY((toolTip() - tool).norm() < 0.5);
    clutch->setChecked(true);  // moves the hand back over the tooth
    waitUntilRead();
    moveHand(6, 4);
    waitForHand();
    clutch->setChecked(false);
    waitUntilRead();
    moveHand(0, 4);
    QTRY_VERIFY_WITH_TIMEOUT((toolTip() - tool).norm() > 4, kPatience);
}

void PenSessionTest::fitToTheToothItIsFinerAndMovesNothing() {
    waitForHand();
    const Vec3 tool = toolTip();
    fit().setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().motionScaling() > 1.5, kPatience);
    waitUntilRead();
    QVERIFY((toolTip() - tool).norm() < 0.05);
    QTRY_COMPARE_WITH_TIMEOUT(motionScaling().value(), window_->model().motionScaling(), kPatience);
    QVERIFY(!motionScaling().isEnabled());
    QVERIFY(window_->findChild<QLabel*>("fitNote")->isHidden());
    QCOMPARE(window_->settings().hand.motionScaling, kAutoScaling);
    moveHand(0, 10);
    waitForHand();
    const double wanted = 6 / window_->model().motionScaling();
    QTRY_VERIFY_WITH_TIMEOUT(std::abs((toolTip() - tool).z() - wanted) < 0.05, kPatience);
}

/// Its workspace ends 80 mm to the right.
void PenSessionTest::atTheWorkspaceLimitTheClutchIsNamed() {
    const QString sentence = "end of the device's workspace";
    QTRY_VERIFY2_WITH_TIMEOUT(!hint().contains(sentence), qPrintable(hint()), kPatience);
    moveHand(79, 10);
    QTRY_VERIFY2_WITH_TIMEOUT(hint().contains(sentence) && hint().contains("(X)"), qPrintable(hint()), kPatience);
    moveHand(0, 4);
    QTRY_VERIFY2_WITH_TIMEOUT(!hint().contains(sentence), qPrintable(hint()), kPatience);
    waitForHand();
    const Vec3 tool = toolTip();
    const double fitted = motionScaling().value();
    fit().setChecked(false);
    waitUntilRead();
    QVERIFY((toolTip() - tool).norm() < 0.05);
    QCOMPARE(window_->settings().hand.motionScaling, fitted);
    motionScaling().setValue(1);
    waitUntilRead();
    QVERIFY((toolTip() - tool).norm() < 0.05);
    QCOMPARE(window_->model().motionScaling(), 1.0);
}

void PenSessionTest::theOtherPenHoldsTheMirror() {
    liftOff();
    const double before = ground();
    chooseDevice("secondDevices", "pen:Left");
    QTRY_COMPARE_WITH_TIMEOUT(standin_->startedPens(), 2, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().runner() != nullptr, kPatience);
    const auto* second = window_->findChild<QLabel*>("secondDeviceState");
    QTRY_COMPARE_WITH_TIMEOUT(second->text(), QString("Touch (stand-in) 'Left': ready"), kPatience);
    QVERIFY(!second->isHidden());
    lean();
    QCOMPARE(standin_->forceOf(1), 0.0);
    QCOMPARE(ground(), before);
    liftOff();
    chooseDevice("secondDevices", "none");
    QTRY_COMPARE_WITH_TIMEOUT(standin_->startedPens(), 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().runner() != nullptr, kPatience);
}

void PenSessionTest::eachFaultMidPressIsSaidAndKeepsTheSession_data() {
    QTest::addColumn<HdFault>("fault");
    QTest::addColumn<QString>("sentence");
    QTest::addColumn<bool>("isLimp");  // or goes on with less force
    QTest::newRow("link") << HdFault::LinkFault << "check its cable" << true;
    if (qEnvironmentVariableIsSet("TACTOOTH_SESSION_SECONDS")) return;  // the short session tests the others
    QTest::newRow("unplugged") << HdFault::Unplugged << "has stopped answering" << true;
    QTest::newRow("device, motors alive") << HdFault::DeviceFault << "reports a fault" << true;
    QTest::newRow("place is no number") << HdFault::NanPose << "is not a number" << true;
    QTest::newRow("jump of 50 mm") << HdFault::Jump << "has jumped" << true;
    QTest::newRow("calibration lost") << HdFault::NeedsInkwell << "inkwell" << true;
    QTest::newRow("warm motors") << HdFault::WarmMotors << "motors are warm" << false;
    QTest::newRow("force cut") << HdFault::TooMuchForce << "press more gently" << false;
}

void PenSessionTest::eachFaultMidPressIsSaidAndKeepsTheSession() {
    QFETCH(const HdFault, fault);
    QFETCH(const QString, sentence);
    QFETCH(const bool, isLimp);
    // 2 ms of the driver's time after the first bad reading.
    breakMidPress(static_cast<int>(fault), sentence, isLimp ? std::optional(3L) : std::nullopt);
}

void PenSessionTest::backToTheMouseThePenIsClosedAndLimp() {
    chooseDevice("devices", "mouse");
    QTRY_COMPARE_WITH_TIMEOUT(standin_->startedPens(), 0, kPatience);
    QCOMPARE(force(), 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(state().contains("mouse"), kPatience);
    waitForTooth();  // the runner restarts
    QVERIFY(removed() > 0.02);
}

void PenSessionTest::aPenThatIsNotThereLeavesTheMouseAndSaysWhatToDo() {
    const auto* devices = window_->findChild<QComboBox*>("devices");
    window_->devices().openFirst("pen:Third");
    QCOMPARE(devices->currentText(), QString("Haptic pen Third"));
    QString said;
    QTRY_VERIFY_WITH_TIMEOUT((said += dismissMessages()).contains("one that is set up (Default Device, Left, Right)"),
                             kPatience);
    QCOMPARE(devices->currentIndex(), 0);
    QVERIFY(window_->model().devices().first() == nullptr);
}

void PenSessionTest::aDeviceThatFailsAtTheStartIsTriedAgainNextTime() {
    QVERIFY(window_->findChild<QLabel*>("secondDeviceState")->isHidden());
    QCOMPARE(window_->settings().hand.device, std::string("mouse"));
    WindowSettings settings = window_->settings();
    settings.hand.device = "pen:Third";
    settings.hand.secondDevice = "pen:Fourth";
    window_->apply(settings);
    QString said;
    QTRY_VERIFY_WITH_TIMEOUT((said += dismissMessages()).contains("Fourth") && said.contains("Third"), kPatience);
    QCOMPARE(window_->settings().hand.device, std::string("pen:Third"));
    QCOMPARE(window_->settings().hand.secondDevice, std::string("pen:Fourth"));
    auto* devices = window_->findChild<QComboBox*>("devices");
    QCOMPARE(devices->currentIndex(), 0);
    emit devices->activated(0);
    QCOMPARE(window_->settings().hand.device, std::string("mouse"));
}

}  // namespace tactooth

int main(int argc, char** argv) {
    setenv("TACTOOTH_LIBHD", TACTOOTH_STANDIN_HD, 1);
    setenv("TACTOOTH_DEVICE_IN_PROCESS", "1", 1);  // the test steers the library that the window has loaded
    const tactooth::test::PenFolder pens({"Default Device", "Left", "Right"});
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::PenSessionTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "pen_session_test.moc"

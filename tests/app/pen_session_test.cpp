// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A whole session with a haptic pen in the real window: the pen is a stand-in for the vendor's library, with a hand on
// a spring inside. $TACTOOTH_SESSION_SECONDS: how long it cuts (default: 3).
#include <dlfcn.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <cstdlib>

#include "app/gui/elided_label.h"
#include "app/gui/window_setup.h"
#include "app/window_session.h"
#include "devices/standin/pen_folder.h"
#include "devices/standin/standin_hd.h"

namespace tactooth {

using test::HdFault;

class PenSessionTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanup() { standin_->setFault(static_cast<int>(HdFault::None)); }
    void eachHandMayChooseAPenByItsName();
    void anUncalibratedPenAsksForItsInkwell();
    void thePenTouchesTheTooth();
    void itsBlueButtonCutsAndThePedalTurnsTheBur();
    void itsWhiteButtonTakesTheMirror();
    void theClutchHoldsTheBur();
    void theOtherPenHoldsTheMirror();
    void eachFaultMidPressIsSaidAndKeepsTheSession_data();
    void eachFaultMidPressIsSaidAndKeepsTheSession();
    void backToTheMouseThePenIsClosedAndLimp();
    void aPenThatIsNotThereLeavesTheMouseAndSaysWhatToDo();
    void aDeviceThatFailsAtTheStartIsTriedAgainNextTime();
    void cleanupTestCase();

private:
    [[nodiscard]] static double force();
    [[nodiscard]] QString state() const { return window_->findChild<QLabel*>("deviceState")->text(); }
    [[nodiscard]] QString hint() const { return window_->findChild<ElidedLabel*>("hint")->text(); }
    [[nodiscard]] QString dismissMessages() const;
    void clickButton(int bit) const;
    void lean();
    void liftOff();
    void waitForRest();
    void strokeFor(double seconds);

    const test::HdStandinControl* standin_ = nullptr;
};

namespace {

constexpr double kIntoTooth = 9;  // mm below the start: the spring of the stand-in's hand then presses with 1 N or two
const test::HdStandinControl* standin() {
    return static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
}

}  // namespace

double PenSessionTest::force() {
    double xyz[3];
    standin()->lastForce(xyz);
    return std::hypot(xyz[0], xyz[1], xyz[2]);
}

/// What the messages in front say, which are closed.
QString PenSessionTest::dismissMessages() const {
    QString said;
    for (QString one = dismissMessage(); !one.isEmpty(); one = dismissMessage()) said += one + '\n';
    return said;
}

void PenSessionTest::clickButton(int bit) const {
    standin_->setButtons(1 << bit);
    QTest::qWait(100);
    standin_->setButtons(0);
    QTest::qWait(100);
}

void PenSessionTest::liftOff() {
    standin_->wantPosition(0, 4, 0);
    QTest::qWait(400);
}

/// The stand-in's hand pulls like a spring, so it is still on its way when it has come near.
void PenSessionTest::waitForRest() {
    const auto held = [this] {
        const Pose& bur = window_->bench().newest().hand;
        return std::pair{bur.position, window_->bench().simulator()->mirrorMotion().position};
    };
    auto before = held();
    const auto isAtRest = [&] {
        QTest::qWait(150);
        const auto now = held();
        const double way = (now.first - before.first).norm() + (now.second - before.second).norm();
        before = now;
        return way < 0.02;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isAtRest(), 10000);
}

/// Down is -y in the frame of the driver. As often as it takes until the tooth is felt.
void PenSessionTest::lean() {
    for (int i = 0; i < 20 && force() < 0.3; ++i) {
        liftOff();
        standin_->wantPosition(0, -kIntoTooth, 0);
        QTest::qWait(800);
    }
    QVERIFY2(force() > 0.3, qPrintable(state()));
}

void PenSessionTest::strokeFor(double seconds) {
    QElapsedTimer since;
    since.start();
    for (double t = 0; t < seconds; t = static_cast<double>(since.elapsed()) / 1000) {
        standin_->wantPosition(0.8 * std::sin(3 * t), -kIntoTooth, 0);
        QTest::qWait(20);
        if (standin_->strongestForce() > 3.3) break;
    }
}

void PenSessionTest::initTestCase() {
    standin_ = standin();
    QVERIFY(standin_ != nullptr);
    openWindow();
    waitForTooth();
    QVERIFY(state().contains("mouse"));
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
    auto* devices = window_->findChild<QComboBox*>("devices");
    devices->setCurrentIndex(devices->findData("pen"));
    emit devices->activated(devices->currentIndex());
    QTRY_VERIFY_WITH_TIMEOUT(window_->bench().device() != nullptr, 20000);
    QTRY_VERIFY_WITH_TIMEOUT(state().contains("inkwell"), 20000);
    QCOMPARE(force(), 0.0);
    QTRY_VERIFY(hint().contains("inkwell"));
    standin_->setFault(static_cast<int>(HdFault::None));
    QTRY_VERIFY_WITH_TIMEOUT(!state().contains("inkwell"), 20000);
    QVERIFY(!hint().contains("inkwell"));
    QCOMPARE(dismissMessages(), QString());  // a hand at work is not stopped by one
    QVERIFY2(state().contains("Touch (stand-in)"), qPrintable(state()));
}

void PenSessionTest::thePenTouchesTheTooth() {
    lean();
    QVERIFY(window_->bench().newest().contacts > 0);
    QCOMPARE(removed(), 0.0);
    QTRY_VERIFY2(state().contains("The force is on"), qPrintable(state()));
}

void PenSessionTest::itsBlueButtonCutsAndThePedalTurnsTheBur() {
    liftOff();
    clickButton(1);
    auto* bar = window_->findChild<QWidget*>("drillBar");
    QTRY_VERIFY_WITH_TIMEOUT(bar->actions().size() > 0 && window_->bench().newest().cutting, 10000);
    window_->findChild<QCheckBox*>("keepPedal")->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(window_->bench().newest().speedRpm > 300'000, 10000);
    lean();
    const char* const seconds = std::getenv("TACTOOTH_SESSION_SECONDS");
    strokeFor(seconds != nullptr ? std::atof(seconds) : 3);
    QTRY_VERIFY_WITH_TIMEOUT(removed() > 0.02, 20000);
    QVERIFY(standin_->strongestForce() <= 3.3);
    window_->findChild<QCheckBox*>("keepPedal")->setChecked(false);
    liftOff();
    clickButton(1);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->bench().newest().cutting, 10000);
}

void PenSessionTest::itsWhiteButtonTakesTheMirror() {
    liftOff();
    waitForRest();
    const Vec3 tool = window_->bench().newest().hand.position;
    const Vec3 mirror = window_->bench().simulator()->mirrorMotion().position;
    clickButton(0);
    standin_->wantPosition(6, 4, 0);
    QTRY_VERIFY_WITH_TIMEOUT((window_->bench().simulator()->mirrorMotion().position - mirror).norm() > 4, 10000);
    QVERIFY((window_->bench().newest().hand.position - tool).norm() < 0.5);
    waitForRest();
    clickButton(0);
    standin_->wantPosition(0, 4, 0);
    QTRY_VERIFY_WITH_TIMEOUT((window_->bench().newest().hand.position - tool).norm() > 4, 10000);
    waitForRest();
    standin_->wantPosition(6, 4, 0);
    QTRY_VERIFY_WITH_TIMEOUT((window_->bench().newest().hand.position - tool).norm() < 1, 10000);
    waitForRest();
}

void PenSessionTest::theClutchHoldsTheBur() {
    const Vec3 tool = window_->bench().newest().hand.position;
    auto* clutch = window_->findChild<QPushButton*>("clutch");
    (void)dismissMessages();  // of a device that a busy machine has stalled: they take all keys
    key(Qt::Key_X);           // which works behind another tab
    QVERIFY(clutch->isChecked());
    QTest::qWait(100);
    standin_->wantPosition(0, 4, 0);
    QTest::qWait(800);
    QVERIFY((window_->bench().newest().hand.position - tool).norm() < 0.5);
    clutch->setChecked(false);
    QTest::qWait(200);
    QVERIFY((window_->bench().newest().hand.position - tool).norm() < 0.5);
    clutch->setChecked(true);  // and back, so that the hand is over the tooth again
    QTest::qWait(100);
    standin_->wantPosition(6, 4, 0);
    QTest::qWait(800);
    clutch->setChecked(false);
    QTest::qWait(200);
    standin_->wantPosition(0, 4, 0);
    QTRY_VERIFY_WITH_TIMEOUT((window_->bench().newest().hand.position - tool).norm() > 4, 10000);
}

void PenSessionTest::theOtherPenHoldsTheMirror() {
    liftOff();
    const double before = removed();
    auto* seconds = window_->findChild<QComboBox*>("secondDevices");
    seconds->setCurrentIndex(seconds->findData("pen:Left"));
    emit seconds->activated(seconds->currentIndex());
    QTRY_COMPARE_WITH_TIMEOUT(standin_->startedPens(), 2, 10000);
    QTRY_VERIFY_WITH_TIMEOUT(window_->bench().simulator() != nullptr, 10000);
    const auto* second = window_->findChild<QLabel*>("secondDeviceState");
    QTRY_COMPARE(second->text(), QString("Touch (stand-in) 'Left': ready"));
    QVERIFY(!second->isHidden());
    lean();
    QCOMPARE(standin_->forceOf(1), 0.0);
    QCOMPARE(removed(), before);
    liftOff();
    seconds->setCurrentIndex(0);
    emit seconds->activated(0);
    QTRY_COMPARE_WITH_TIMEOUT(standin_->startedPens(), 1, 10000);
    QTRY_VERIFY_WITH_TIMEOUT(window_->bench().simulator() != nullptr, 10000);
}

void PenSessionTest::eachFaultMidPressIsSaidAndKeepsTheSession_data() {
    QTest::addColumn<HdFault>("fault");
    QTest::addColumn<QString>("sentence");
    QTest::addColumn<bool>("isLimp");  // or goes on, more weakly
    QTest::newRow("link") << HdFault::LinkFault << "check its cable" << true;
    if (qEnvironmentVariableIsSet("TACTOOTH_SESSION_SECONDS")) return;  // the short session goes through the others
    QTest::newRow("unplugged") << HdFault::Unplugged << "has stopped answering" << true;
    QTest::newRow("device, motors alive") << HdFault::DeviceFault << "reports a fault" << true;
    QTest::newRow("place is no number") << HdFault::NanPose << "is no number" << true;
    QTest::newRow("jump of 50 mm") << HdFault::Jump << "has jumped" << true;
    QTest::newRow("calibration lost") << HdFault::NeedsInkwell << "inkwell" << true;
    QTest::newRow("warm motors") << HdFault::WarmMotors << "motors are warm" << false;
    QTest::newRow("force cut") << HdFault::TooMuchForce << "press more gently" << false;
}

void PenSessionTest::eachFaultMidPressIsSaidAndKeepsTheSession() {
    QFETCH(const HdFault, fault);
    QFETCH(const QString, sentence);
    QFETCH(const bool, isLimp);
    lean();
    const double before = removed();
    standin_->setFault(static_cast<int>(fault));
    QTRY_VERIFY2_WITH_TIMEOUT(state().contains(sentence), qPrintable(state()), 10000);
    QTRY_VERIFY2(hint().contains(sentence), qPrintable(hint()));
    if (isLimp) {
        QTest::qWait(50);
        QCOMPARE(standin_->strongestWhileFaulty(), 0.0);
        QVERIFY(standin_->lastForceSinceFault() <= 3);  // 2 ms after the first bad reading, of the driver's own time
    }
    standin_->setFault(static_cast<int>(HdFault::None));
    QTRY_VERIFY2_WITH_TIMEOUT(!state().contains(sentence), qPrintable(state()), 20000);
    QCOMPARE(dismissMessages(), QString());
    QCOMPARE(removed(), before);
    lean();
}

void PenSessionTest::backToTheMouseThePenIsClosedAndLimp() {
    auto* devices = window_->findChild<QComboBox*>("devices");
    devices->setCurrentIndex(0);
    emit devices->activated(0);
    QTRY_COMPARE_WITH_TIMEOUT(standin_->startedPens(), 0, 10000);
    QCOMPARE(force(), 0.0);
    QTRY_VERIFY(state().contains("mouse"));
    QVERIFY(removed() > 0.02);
}

void PenSessionTest::aPenThatIsNotThereLeavesTheMouseAndSaysWhatToDo() {
    const auto* devices = window_->findChild<QComboBox*>("devices");
    window_->steerBy("pen:Third");
    QCOMPARE(devices->currentText(), QString("Haptic pen Third"));
    QString said;
    QTRY_VERIFY_WITH_TIMEOUT((said += dismissMessages()).contains("one that is set up (Default Device, Left, Right)"),
                             20000);
    QCOMPARE(devices->currentIndex(), 0);
    QVERIFY(window_->bench().device() == nullptr);
}

void PenSessionTest::aDeviceThatFailsAtTheStartIsTriedAgainNextTime() {
    QVERIFY(window_->findChild<QLabel*>("secondDeviceState")->isHidden());
    QCOMPARE(window_->settings().hand.device, std::string("mouse"));
    WindowSettings settings = window_->settings();
    settings.hand.device = "pen:Third";
    settings.hand.secondDevice = "pen:Fourth";
    window_->apply(settings);
    QString said;
    QTRY_VERIFY_WITH_TIMEOUT((said += dismissMessages()).contains("Fourth") && said.contains("Third"), 20000);
    QCOMPARE(window_->settings().hand.device, std::string("pen:Third"));
    QCOMPARE(window_->settings().hand.secondDevice, std::string("pen:Fourth"));
    auto* devices = window_->findChild<QComboBox*>("devices");
    QCOMPARE(devices->currentIndex(), 0);
    emit devices->activated(0);
    QCOMPARE(window_->settings().hand.device, std::string("mouse"));
}

void PenSessionTest::cleanupTestCase() { closeWindow(); }

}  // namespace tactooth

int main(int argc, char** argv) {
    setenv("TACTOOTH_LIBHD", TACTOOTH_STANDIN_HD, 1);
    const tactooth::test::PenFolder pens({"Default Device", "Left", "Right"});
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::PenSessionTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "pen_session_test.moc"

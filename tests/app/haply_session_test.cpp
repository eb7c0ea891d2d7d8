// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A whole session with a Haply Inverse3 in the real window: the service that it is reached through is a stand-in, with
// a hand on a spring inside. $TACTOOTH_SESSION_SECONDS: how long it cuts; then it goes through all faults, else
// through one.
#include <QApplication>
#include <QComboBox>
#include <cstdlib>

#include "app/device_session.h"
#include "app/gui/settings/window_setup.h"
#include "devices/standin/standin_haply.h"

namespace tactooth {

using test::HaplyFault;
using test::StandinHaply;

class HaplySessionTest : public test::DeviceSession {
    Q_OBJECT

public:
    explicit HaplySessionTest(StandinHaply& service) : service_(service) {}

private slots:
    void initTestCase();
    void cleanup() { setFault(0); }
    void theArmTakesTheTool();
    void itTouchesTheTooth() { touchTheTooth(); }
    void theGripTurnsTheBur();
    void buttonBCutsAndThePedalTurnsTheBur() { cutByButtonAndPedal(1, secondsToCut()); }
    void buttonATakesTheMirror() { takeTheMirrorByButton(0); }
    void buttonCHoldsTheBur();
    void eachFaultMidPressIsSaidAndKeepsTheSession_data();
    void eachFaultMidPressIsSaidAndKeepsTheSession();
    void backToTheMouseTheConnectionIsClosed();
    void aServiceThatCannotBeUsedLeavesTheMouseAndSaysWhatToDo_data();
    void aServiceThatCannotBeUsedLeavesTheMouseAndSaysWhatToDo();
    void cleanupTestCase() { closeWindow(); }

private:
    /// In metres, z up.
    void moveHand(double right, double up) const override { service_.wantPosition(1e-3 * right, 0, 1e-3 * up); }
    void setButtons(unsigned down) const override { service_.setGrip({1, 0, 0, 0}, down); }
    [[nodiscard]] double force() const override { return service_.force(); }
    [[nodiscard]] long exchanges() const override { return service_.messages(); }
    void setFault(int fault) const override { service_.setFault(static_cast<HaplyFault>(fault)); }
    [[nodiscard]] long lastForceSinceFault() const override { return service_.lastForceSinceFault(); }

    [[nodiscard]] static const char* longSession() { return std::getenv("TACTOOTH_SESSION_SECONDS"); }
    [[nodiscard]] static double secondsToCut() { return longSession() != nullptr ? std::atof(longSession()) : 1; }

    StandinHaply& service_;
};

void HaplySessionTest::initTestCase() {
    openWindow();
    WindowSettings settings = window_->settings();
    settings.hand.device = "inverse3";  // as with --device inverse3
    window_->apply(settings);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().devices().first() != nullptr, kPatience);
}

void HaplySessionTest::theArmTakesTheTool() {
    QTRY_VERIFY2_WITH_TIMEOUT(state().contains("Haply Inverse3 049D: The force is on"), qPrintable(state()), kPatience);
    QCOMPARE(window_->findChild<QComboBox*>("devices")->currentData(), QVariant("inverse3"));
    const double before = toolTip().z();
    moveHand(0, 5);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(toolTip().z() - before - 5) < 0.1, kPatience);
    QCOMPARE(dismissMessages(), QString());
}

void HaplySessionTest::theGripTurnsTheBur() {
    liftOff();
    const Vec3 shaft = window_->model().log().newest().input.device.rotation * Vec3::UnitZ();
    const auto leansBy = [&](double cosine) {
        const Vec3 now = window_->model().log().newest().input.device.rotation * Vec3::UnitZ();
        return std::abs(now.dot(shaft) - cosine) < 1e-3;
    };
    const double half = 0.25;  // rad
    service_.setGrip({std::cos(half), std::sin(half), 0, 0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(leansBy(std::cos(2 * half)), kPatience);
    service_.setGrip({1, 0, 0, 0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(leansBy(1), kPatience);
}

void HaplySessionTest::buttonCHoldsTheBur() {
    const Vec3 tool = toolTip();
    setButtons(4);
    waitUntilRead();
    moveHand(0, 10);
    waitForHand();
    QVERIFY((toolTip() - tool).norm() < 0.1);
    setButtons(0);
    waitUntilRead();
    QVERIFY((toolTip() - tool).norm() < 0.1);
    moveHand(0, 15);
    QTRY_VERIFY_WITH_TIMEOUT((toolTip() - tool - Vec3(0, 0, 5)).norm() < 0.1, kPatience);
    setButtons(4);  // to intact enamel: a long device could fall into the cut
    waitUntilRead();
    moveHand(2.5, 9);
    waitForHand();
    setButtons(0);
    waitUntilRead();
}

void HaplySessionTest::eachFaultMidPressIsSaidAndKeepsTheSession_data() {
    QTest::addColumn<HaplyFault>("fault");
    QTest::addColumn<QString>("sentence");
    QTest::addColumn<bool>("isLoss");  // no new position comes, or it is refused
    QTest::newRow("connection lost") << HaplyFault::Drop << "has closed the connection" << true;
    if (longSession() == nullptr) return;  // each takes as long as its sentence is shown
    QTest::newRow("slow") << HaplyFault::Slow << "answers too slowly" << true;
    QTest::newRow("no answer") << HaplyFault::Mute << "has stopped answering" << true;
    QTest::newRow("no message") << HaplyFault::Malformed << "messages that cannot be read" << true;
    QTest::newRow("other version") << HaplyFault::Version << "install version 3" << true;
    QTest::newRow("other units") << HaplyFault::Units << "not in metres" << true;
    QTest::newRow("unplugged") << HaplyFault::Gone << "is gone" << true;
    QTest::newRow("jump of 50 mm") << HaplyFault::Jump << "has jumped" << false;
    QTest::newRow("two answers a message") << HaplyFault::Double << "sends more answers" << true;
    QTest::newRow("twenty answers a message") << HaplyFault::Twenty << "sends more answers" << true;
    QTest::newRow("20,000 answers a second") << HaplyFault::Flood << "sends more answers" << true;
    QTest::newRow("four numbers that are no turn")
        << HaplyFault::InvalidRotation << "an orientation that is not valid" << false;
    QTest::newRow("turned to and fro") << HaplyFault::FlippingTurn << "orientation has jumped" << false;
    QTest::newRow("jitter of 4.9 mm") << HaplyFault::Jitter << "position has jumped" << false;
    QTest::newRow("drift of 3 m/s") << HaplyFault::Drift << "position has jumped" << false;
    QTest::newRow("place is no number") << HaplyFault::NotANumber << "has lost its position" << false;
    QTest::newRow("no power") << HaplyFault::NoPower << "plug in its power supply" << false;
    QTest::newRow("calibration lost") << HaplyFault::NotCalibrated << "is not calibrated" << false;
    QTest::newRow("not ready") << HaplyFault::NotReady << "is not ready" << false;
}

void HaplySessionTest::eachFaultMidPressIsSaidAndKeepsTheSession() {
    QFETCH(const HaplyFault, fault);
    QFETCH(const QString, sentence);
    QFETCH(const bool, isLoss);
    // In messages, one each millisecond: the first is under way when the fault begins, then 5 ms, or 2.
    breakMidPress(static_cast<int>(fault), sentence, isLoss ? 6 : 3);
    QCOMPARE(service_.connections(), 1);
}

void HaplySessionTest::backToTheMouseTheConnectionIsClosed() {
    chooseDevice("devices", "mouse");
    QTRY_COMPARE_WITH_TIMEOUT(service_.connections(), 0, kPatience);
    QCOMPARE(force(), 0.0);
    QTRY_VERIFY_WITH_TIMEOUT(state().contains("mouse"), kPatience);
    waitForTooth();  // the runner restarts
    QVERIFY(removed() > 0.02);
}

void HaplySessionTest::aServiceThatCannotBeUsedLeavesTheMouseAndSaysWhatToDo_data() {
    QTest::addColumn<HaplyFault>("fault");
    QTest::addColumn<QString>("device");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("other version") << HaplyFault::Version << "inverse3"
                                   << "install version 3";
    QTest::newRow("other units") << HaplyFault::Units << "inverse3"
                                 << "not in metres";
    QTest::newRow("another device") << HaplyFault::None << "inverse3:FFFF"
                                    << "it finds 049D, 0B1C";
}

void HaplySessionTest::aServiceThatCannotBeUsedLeavesTheMouseAndSaysWhatToDo() {
    QFETCH(const HaplyFault, fault);
    QFETCH(const QString, device);
    QFETCH(const QString, sentence);
    service_.setFault(fault);
    window_->devices().openFirst(device);
    QString said;
    QTRY_VERIFY_WITH_TIMEOUT((said += dismissMessages()).contains(sentence), kPatience);
    QCOMPARE(window_->findChild<QComboBox*>("devices")->currentData(), QVariant("mouse"));
    QVERIFY(window_->model().devices().first() == nullptr);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    tactooth::test::StandinHaply service;
    setenv("TACTOOTH_HAPLY", service.address().c_str(), 1);
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::HaplySessionTest test(service);
    return QTest::qExec(&test, argc, argv);
}

#include "haply_session_test.moc"

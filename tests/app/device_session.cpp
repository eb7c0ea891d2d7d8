// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/device_session.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <cmath>

#include "app/gui/panels/elided_label.h"

namespace tactooth::test {
namespace {

constexpr double kIntoTooth = 9;  // mm below the start: the spring of the stand-in's hand then presses with 1 N or two
constexpr double kAbove = 4;      // mm, free of the tooth
constexpr double kAside = 6;      // mm
constexpr double kContactForce = 0.3;  // N
constexpr double kEnoughCut = 0.02;    // mm^3

}  // namespace

QString DeviceSession::state() const { return window_->findChild<QLabel*>("deviceState")->text(); }
QString DeviceSession::hint() const { return window_->findChild<ElidedLabel*>("hint")->text(); }

QString DeviceSession::dismissMessages() const {
    QString said;
    for (QString one = dismissMessage(); !one.isEmpty(); one = dismissMessage()) said += one + '\n';
    return said;
}

void DeviceSession::chooseDevice(const char* list, const QString& name) const {
    auto* devices = window_->findChild<QComboBox*>(list);
    devices->setCurrentIndex(devices->findData(name));
    emit devices->activated(devices->currentIndex());
}

void DeviceSession::waitUntilRead() const {
    constexpr long kOnTheWay = 120;  // exchanges: a stall of the machine hides the device for 100 of them
    const long before = exchanges();
    QTRY_VERIFY_WITH_TIMEOUT(exchanges() > before + kOnTheWay, kPatience);
    for (int step = 0; step < 3;
         ++step) {  // steps of the window: one sends, one receives, and one may have been under way
        const double time = window_->model().log().newest().time;
        QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().time > time, kPatience);
    }
}

void DeviceSession::waitForHand() const {
    constexpr long kArrives = 250;  // exchanges: its spring is critically damped at 50/s
    const long before = exchanges();
    QTRY_VERIFY_WITH_TIMEOUT(exchanges() > before + kArrives, kPatience);
    waitUntilRead();
}

void DeviceSession::clickButton(int button) const {
    setButtons(1U << static_cast<unsigned>(button));
    waitUntilRead();
    setButtons(0);
    waitUntilRead();
}

/// A lost device stays where it was and may come back later: see lean.
void DeviceSession::liftOff() const {
    moveHand(0, kAbove);
    (void)QTest::qWaitFor([this] { return force() == 0 && window_->model().log().newest().contact.triangles == 0; },
                          3000);
}

/// A stalled machine stops the force until the hand has lifted off.
void DeviceSession::lean() const {
    bool isPressed = force() > kContactForce;
    for (int i = 0; i < 20 && !isPressed; ++i) {
        liftOff();
        moveHand(0, -kIntoTooth);
        isPressed = QTest::qWaitFor([this] { return force() > kContactForce; }, 2000);
    }
    QVERIFY2(isPressed, qPrintable(state()));
}

void DeviceSession::touchTheTooth() const {
    lean();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
    QCOMPARE(removed(), 0.0);
    const auto isOn = [this] {
        if (!state().contains("The force is on")) lean();
        return state().contains("The force is on");
    };
    QTRY_VERIFY2_WITH_TIMEOUT(isOn(), qPrintable(state()), kPatience);
}

void DeviceSession::cutByButtonAndPedal(int button, double seconds) const {
    liftOff();
    clickButton(button);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().input.cutting, kPatience);
    auto* pedal = window_->findChild<QCheckBox*>("keepPedal");
    pedal->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().spindle.speedRpm > 300'000, kPatience);
    const double before = removed();
    QElapsedTimer since;
    since.start();
    const auto isCut = [&] {
        const double t = static_cast<double>(since.elapsed()) / 1000;
        moveHand(0.8 * std::sin(3 * t), -kIntoTooth);
        return t > seconds && removed() > before + kEnoughCut;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isCut(), kPatience + static_cast<int>(1000 * seconds));
    pedal->setChecked(false);
    liftOff();
    clickButton(button);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->model().log().newest().input.cutting, kPatience);
}

void DeviceSession::takeTheMirrorByButton(int button) const {
    liftOff();
    waitForHand();
    const Vec3 tool = toolTip(), mirror = mirrorMotion();
    clickButton(button);
    moveHand(kAside, kAbove);
    QTRY_VERIFY_WITH_TIMEOUT((mirrorMotion() - mirror).norm() > 4, kPatience);
    QVERIFY((toolTip() - tool).norm() < 0.5);
    waitForHand();
    clickButton(button);
    moveHand(0, kAbove);
    QTRY_VERIFY_WITH_TIMEOUT((toolTip() - tool).norm() > 4, kPatience);
    waitForHand();
    moveHand(kAside, kAbove);
    QTRY_VERIFY_WITH_TIMEOUT((toolTip() - tool).norm() < 1, kPatience);
    waitForHand();
}

void DeviceSession::breakMidPress(int fault, const QString& sentence, std::optional<long> longestForce) const {
    lean();
    const double before = ground();
    const LiveRunner* const session = window_->model().runner();
    const std::size_t events = window_->model().log().events().all().size();
    const double began = window_->model().log().newest().time;
    setFault(fault);
    QTRY_VERIFY2_WITH_TIMEOUT(state().contains(sentence), qPrintable(state()), kPatience);
    QTRY_VERIFY2_WITH_TIMEOUT(hint().contains(sentence), qPrintable(hint()), kPatience);
    auto* ghost = window_->findChild<QCheckBox*>("ghost");
    ghost->toggle();
    ghost->toggle();
    QVERIFY2(hint().contains(sentence), qPrintable("a hint covers the fault: " + hint()));
    if (longestForce) {
        const double now = window_->model().log().newest().time;  // a late force would come now
        QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().time > now + 0.05, kPatience);
        QVERIFY2(lastForceSinceFault() <= *longestForce, qPrintable(QString::number(lastForceSinceFault())));
        QCOMPARE(force(), 0.0);
    }
    setFault(0);
    QTRY_VERIFY2_WITH_TIMEOUT(!state().contains(sentence), qPrintable(state()), kPatience);
    QCOMPARE(dismissMessages(), QString());  // they would take the keys and the pedal
    QCOMPARE(ground(), before);
    QVERIFY(window_->model().runner() == session && window_->model().log().newest().time > began);
    QVERIFY(window_->model().log().events().all().size() >= events);
    lean();
}

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window_session.h"

#include <QApplication>

namespace tactooth::test {

void WindowSession::openWindow() {
    sound_ = std::make_unique<OpenAlOutput>();
    window_ = std::make_unique<MainWindow>(*sound_);
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    window_->teeth().loadBur(*findBur("4"));
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void WindowSession::openWindowWithSettings() {
    openWindow();
    window_->apply(window_->settings());
}

void WindowSession::waitForTooth() {
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isBusy() && window_->model().simulator() != nullptr, 60000);
}

void WindowSession::key(Qt::Key which, Qt::KeyboardModifiers with) const {
    QApplication::setActiveWindow(window_.get());  // a bare X server has no window manager that would do it
    QTest::keyClick(window_.get(), which, with);
}

void WindowSession::pressBurOn(const QPoint& place) const {
    QTest::mouseMove(&view(), place);
    QTest::qWait(300);
    QTest::mousePress(&view(), Qt::LeftButton, {}, place);
}

void WindowSession::liftBur(const QPoint& place) const {
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, place);
    QTest::qWait(300);
}

QString WindowSession::dismissMessage() const {
    auto* box = window_->findChild<QMessageBox*>();
    if (box == nullptr) return {};
    const QString text = box->text();
    delete box;
    return text;
}

void WindowSession::closeWindow() {
    window_.reset();
    sound_.reset();
}

void WindowSession::loadMolar() {
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("molar"), 60000);
    waitForTooth();
}

}  // namespace tactooth::test

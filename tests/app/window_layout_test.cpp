// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where things are in the window, what the view keys reset, and what another language leaves as it was.
#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/settings/window_setup.h"
#include "app/gui/window/window_owner.h"
#include "app/window_session.h"

namespace tactooth {

class WindowLayoutTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void ctrlShiftSAsksWhereToExportTheTooth();
    void cleanupTestCase();
};

void WindowLayoutTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());  // the cache of teeth
    openWindowWithSettings();
    waitForTooth();
}

void WindowLayoutTest::cleanupTestCase() { closeWindow(); }

/// Also where the desktop has no key of its own for "Save as".
void WindowLayoutTest::ctrlShiftSAsksWhereToExportTheTooth() {
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    auto* dialog = window_->findChild<QFileDialog*>();
    QCOMPARE(dialog->acceptMode(), QFileDialog::AcceptSave);
    QVERIFY2(dialog->windowTitle().contains("Export"), qPrintable(dialog->windowTitle()));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowLayoutTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_layout_test.moc"

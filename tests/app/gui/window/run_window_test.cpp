// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program's window from its settings file to its end: one run a process, since Qt has one application.
#include "app/gui/window/run_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMessageBox>
#include <QTimer>
#include <cstdlib>
#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "app/gui/window/main_window.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

constexpr int kCheckInterval = 20;  // ms between two checks of the window
constexpr int kChecksBefore = 5;    // checks of the loaded window in which a second message could come

std::vector<std::string> messages;

void takeMessages() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* const box = qobject_cast<QMessageBox*>(widget);
        if (box == nullptr || !box->isVisible()) continue;
        messages.push_back(box->text().toStdString());
        box->close();
    }
}

MainWindow* mainWindow() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* const window = qobject_cast<MainWindow*>(widget)) return window;
    }
    return nullptr;
}

/// Reads the messages and closes the window when all is loaded.
void visitWindow() {
    auto* const timer = new QTimer(QCoreApplication::instance());
    QObject::connect(timer, &QTimer::timeout, timer, [checks = 0]() mutable {
        takeMessages();
        MainWindow* const window = mainWindow();
        if (window == nullptr || window->isBusy() || window->model().runner() == nullptr) return;
        if (++checks >= kChecksBefore) window->close();
    });
    timer->start(kCheckInterval);
}
Q_COREAPP_STARTUP_FUNCTION(visitWindow)

TEST(RunWindow, ADeviceThatNobodyKnowsIsSaidOnceAndNotKept) {
    const test::TemporaryFolder home;
    setenv("XDG_CONFIG_HOME", home.path().c_str(), 1);
    WindowSettings settings;
    settings.hand.device = "joystick";
    settings.hand.secondDevice = "bogus";
    settings.hand.motionScaling = 2;
    ASSERT_TRUE(writeWindowSettings(settings, windowSettingsFile()));
    EXPECT_EQ(runWindow({}), kExitOk);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages.front().find("'joystick'"), std::string::npos) << messages.front();
    EXPECT_NE(messages.front().find("'bogus'"), std::string::npos) << messages.front();
    const auto kept = readWindowSettings(windowSettingsFile());
    ASSERT_TRUE(kept) << kept.error().message();
    EXPECT_EQ(kept->hand.device, "mouse");
    EXPECT_EQ(kept->hand.secondDevice, "none");
    EXPECT_EQ(kept->hand.motionScaling, 2) << "all else is kept";
}

}  // namespace
}  // namespace tactooth

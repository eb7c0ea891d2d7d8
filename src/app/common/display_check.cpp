// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/display_check.h"

#include <unistd.h>

#include <QGuiApplication>
#include <cstdlib>
#include <string>

#include "devices/child_probe.h"

namespace tactooth {
namespace {

constexpr double kPatience = 20;  // s: a display on another computer may be far away

std::string valueOf(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? std::string() : std::string(value);
}

/// Qt's last word before it aborts; an exit leaves no core file and no entry in the system's list of crashes.
void endOnFatal(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type == QtFatalMsg) _exit(1);
}

/// All that Qt does before the first window, so that no platform and no way to it has to be known here.
std::string startQt() {
    qInstallMessageHandler(endOnFatal);
    int argc = 1;
    char name[] = "tactooth";
    char* argv[] = {name, nullptr};
    const QGuiApplication application(argc, argv);
    return {};
}

/// What the environment asks for that is not to be had, and the way out of that, up to where the others follow.
std::string whatIsWrong() {
    if (const std::string platform = valueOf("QT_QPA_PLATFORM"); !platform.empty()) {
        return "no window can be opened on Qt's platform '" + platform + "'; unset QT_QPA_PLATFORM, ";
    }
    if (const std::string display = valueOf("DISPLAY"); !display.empty()) {
        return "the display '" + display + "' (DISPLAY) cannot be reached or lets nobody in; ";
    }
    if (const std::string display = valueOf("WAYLAND_DISPLAY"); !display.empty()) {
        return "the display '" + display + "' (WAYLAND_DISPLAY) cannot be used; install the package qt6-wayland, ";
    }
    return "there is no display to open a window on; ";
}

}  // namespace

Expected<void> checkDisplay() {
    if (inChildProcess(startQt, kPatience)) return {};
    return unexpected(whatIsWrong() +
                      "start it from a desktop or by 'ssh -X' from another computer, or use 'tactooth demo --out DIR', "
                      "which needs no display.");
}

}  // namespace tactooth

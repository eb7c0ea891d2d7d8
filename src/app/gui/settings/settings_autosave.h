// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "app/gui/settings/window_settings.h"

namespace tactooth {

/// Writes the window's settings soon after they have changed, so that a program that is killed does not lose them. It
/// compares them once in each interval, so no part of the window has to report a change. It writes a change when
/// nothing has changed for one interval more. A failure is reported only when the program ends.
class SettingsAutosave {
public:
    /// `settings` returns those of the window. Those of the first call count as written.
    SettingsAutosave(std::function<WindowSettings()> settings, std::filesystem::path file,
                     std::chrono::milliseconds interval = std::chrono::seconds(1));

private:
    void check();

    std::function<WindowSettings()> settings_;
    std::filesystem::path file_;
    std::string seen_;   // in the last interval
    std::string tried_;  // in the last attempt to write
    QTimer timer_;
};

}  // namespace tactooth

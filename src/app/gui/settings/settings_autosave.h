// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <filesystem>
#include <functional>
#include <string>

#include "app/gui/settings/window_settings.h"

namespace tactooth {

/// Writes the window's settings soon after they have changed, so that they are not lost with a program that is killed.
/// It looks at them itself once a second: whatever part of the window has changed one need not know of it. A change is
/// written when nothing has changed for a second more. What cannot be written is told at the end of the program.
class SettingsAutosave {
public:
    /// `settings` are those of the window; they count as written when this is made.
    SettingsAutosave(std::function<WindowSettings()> settings, std::filesystem::path file);

private:
    void check();

    std::function<WindowSettings()> settings_;
    std::filesystem::path file_;
    std::string seen_;   // by the last look
    std::string tried_;  // to be written
    QTimer timer_;
};

}  // namespace tactooth

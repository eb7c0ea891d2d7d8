// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/settings/window_settings.h"

namespace tactooth {

struct InputControllers;
struct OutputControllers;
struct WindowFrame;
class WindowMenus;
struct WorkControllers;
struct WorkTools;

/// Between the settings and the parts of the window that they set.
class SettingsBinding {
public:
    /// All of them outlive the binding.
    SettingsBinding(WindowFrame& frame, WorkControllers& work, InputControllers& input, OutputControllers& output,
                    WindowMenus& menus, WorkTools& tools);

    /// The window as it was the last time. Call it before the window is shown.
    void apply(const WindowSettings& settings);
    [[nodiscard]] WindowSettings current() const;
    /// Takes over what differs from current(), but for layout, keys and language, while the work goes on.
    void change(const WindowSettings& wanted);

private:
    WindowFrame& frame_;
    WorkControllers& work_;
    InputControllers& input_;
    OutputControllers& output_;
    WindowMenus& menus_;
    WorkTools& tools_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/dialogs/setting_row.h"

namespace tactooth {

/// The burs, drives and devices that can be chosen now, by the flags of their settings.
[[nodiscard]] std::map<std::string, SettingChoices> settingsChoices(const WindowPanels& panels);

}  // namespace tactooth

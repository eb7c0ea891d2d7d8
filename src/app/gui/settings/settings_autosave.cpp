// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings/settings_autosave.h"

#include <utility>

namespace tactooth {

SettingsAutosave::SettingsAutosave(std::function<WindowSettings()> settings, std::filesystem::path file,
                                   std::chrono::milliseconds interval)
    : settings_(std::move(settings)), file_(std::move(file)), seen_(windowSettingsText(settings_())), tried_(seen_) {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { check(); });
    timer_.start(interval);
}

void SettingsAutosave::check() {
    const WindowSettings settings = settings_();
    const std::string before = std::exchange(seen_, windowSettingsText(settings));
    if (seen_ != before || seen_ == tried_) return;
    tried_ = seen_;
    (void)writeWindowSettings(settings, file_).has_value();
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <map>
#include <string>
#include <vector>

#include "app/gui/dialogs/setting_row.h"

class QListWidget;
class QStackedWidget;

namespace tactooth {

/// All settings that the user can choose, in pages: each with what it does, its unit and its usual value. A change acts
/// at once.
class SettingsDialog final : public QDialog {
    Q_OBJECT

public:
    /// `choices`: by the flag of the setting, for texts whose values depend on catalogue and devices.
    SettingsDialog(const WindowSettings& now, const std::map<std::string, SettingChoices>& choices, QWidget* parent);

    /// With the changes so far.
    [[nodiscard]] const WindowSettings& settings() const { return settings_; }

signals:
    void changed();
    /// The user wants to change keys; the dialog is closed.
    void keysWanted();

private:
    struct Page {
        SettingsPage page;
        std::vector<SettingRow*> rows;
    };
    void addPage(SettingsPage page, const std::map<std::string, SettingChoices>& choices);
    void addButtons();
    void reset(const std::vector<Page*>& pages);

    WindowSettings settings_;
    QListWidget* names_;
    QStackedWidget* stack_;
    std::vector<Page> pages_;
};

}  // namespace tactooth

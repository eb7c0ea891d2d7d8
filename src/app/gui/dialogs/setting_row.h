// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

#include "app/gui/settings/window_settings.h"

class QGridLayout;

namespace tactooth {

/// The values that a text may have, for the user and for the settings.
using SettingChoices = std::vector<std::pair<QString, QString>>;

/// One setting in the dialog: what it does, its control and its usual value, made from the row of windowOptions().
class SettingRow final : public QObject {
    Q_OBJECT

public:
    /// Adds itself to `grid`. `choices`: for a text that has no words of its own in the table; empty: any text.
    SettingRow(const WindowOption& option, const SettingChoices& choices, QGridLayout& grid);

    [[nodiscard]] const WindowOption& option() const { return option_; }
    /// Shows the value of `settings`; emits nothing.
    void show(WindowSettings settings);
    /// Shows the usual value; emits nothing.
    void showUsual();
    /// Writes the value into `settings`.
    void store(WindowSettings& settings) const { store_(settings); }

signals:
    void changed();

private:
    QWidget* makeSwitch(WindowOption::Switch value);
    QWidget* makeNumber(WindowOption::Number value);
    QWidget* makeChoice(WindowOption::Text value, const SettingChoices& choices);
    QWidget* makeText(WindowOption::Text value);

    const WindowOption& option_;
    QString usualText_;
    std::function<void(WindowSettings&)> show_, store_;
};

}  // namespace tactooth

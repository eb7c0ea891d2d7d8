// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/settings/window_settings.h"

class QAction;
class QActionGroup;
class QMenu;

namespace tactooth {

/// Colours, text size and language of the window.
class AppearanceMenu final : public QObject {
    Q_OBJECT

public:
    /// Adds its actions to `menu`.
    explicit AppearanceMenu(QMenu& menu);

    void restore(const WindowSettings& settings);
    void store(WindowSettings& settings) const;
    /// As if it had been chosen in the menu.
    void chooseLanguage(const QString& code);
    [[nodiscard]] const QString& language() const { return language_; }

signals:
    void coloursChanged();
    void textScaleChanged();
    /// The user has chosen another language than that of this window.
    void languageChosen();

private:
    void addTextSizes(QMenu& menu);
    void addLanguages(QMenu& menu);
    void setTextScale(double scale);
    void setLanguage(const QString& code);

    QAction* dark_;
    QActionGroup* textSizes_ = nullptr;
    QActionGroup* languages_ = nullptr;
    double textScale_ = 1;
    QString language_;  // empty: the system's
};

}  // namespace tactooth

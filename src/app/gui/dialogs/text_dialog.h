// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace tactooth {

/// A text that is as long as it needs to be: with large letters on a small screen it is scrolled, by keys as well.
class TextDialog final : public QDialog {
    Q_OBJECT

public:
    /// `html`: what it says.
    TextDialog(const QString& title, const QString& html, QWidget* parent);

    [[nodiscard]] QString text() const;
};

}  // namespace tactooth

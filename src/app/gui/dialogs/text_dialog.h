// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace tactooth {

/// A dialog with a text of any length. With a large font on a small screen the text scrolls, also by keys.
class TextDialog final : public QDialog {
    Q_OBJECT

public:
    /// `html`: the text.
    TextDialog(const QString& title, const QString& html, QWidget* parent);

    [[nodiscard]] QString text() const;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace tactooth {

/// The bur in the handpiece. Arrow keys go to the next one; where other boxes open a list, this one asks for the grid
/// of pictures.
class BurBox final : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    void showPopup() override { emit gridWanted(); }

signals:
    void gridWanted();
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QGroupBox>
#include <QLabel>

#include "app/gui/editor/draft_ideal.h"

namespace tactooth {

/// What the editor's panel says about the ideal cavity of a draft, and the choice whether the picture shows it.
class IdealBox final : public QGroupBox {
    Q_OBJECT

public:
    IdealBox();

    /// `opensPulp`: Exercise::opensPulp, which is then nothing to warn of.
    void show(const DraftIdeal& ideal, bool opensPulp);
    [[nodiscard]] bool isChosen() const { return shows_->isChecked(); }

signals:
    void chosen();

private:
    void showCavity(const IdealCavity& cavity, bool opensPulp);
    void warn(const QString& sentence);

    QCheckBox* shows_;
    QLabel* state_;
};

}  // namespace tactooth

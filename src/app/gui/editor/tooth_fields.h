// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QButtonGroup>
#include <QCheckBox>
#include <QPushButton>
#include <array>

#include "app/gui/editor/draft_fields.h"
#include "app/gui/editor/exercise_template.h"
#include "app/gui/editor/outline_tool.h"

namespace tactooth {

/// The tooth, what its cavity begins with, and what a click draws.
class ToothFields final : public DraftFields {
    Q_OBJECT

public:
    ToothFields();

    /// What a click draws now, and whether there is a zone to remove.
    void showStroke(DraftStroke stroke, bool hasZone);

signals:
    void templateWanted(ExerciseTemplate kind);
    void freeOutlineWanted();
    void strokeChosen(DraftStroke stroke);
    void newZoneWanted();
    void zoneRemovalWanted();

protected:
    void showDraft(const ExerciseDraft& draft) override;

private:
    void addTemplates();
    void addStrokes();

    QComboBox* tooth_;
    QCheckBox* inMouth_;
    std::array<QPushButton*, 4> templates_{};
    QButtonGroup* strokes_;
    QPushButton* removeZone_;
};

}  // namespace tactooth

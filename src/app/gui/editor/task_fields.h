// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QLineEdit>
#include <QListWidget>

#include "app/gui/editor/draft_fields.h"

namespace tactooth {

/// The instruments, the words for the student, and how the work is judged.
class TaskFields final : public DraftFields {
    Q_OBJECT

public:
    TaskFields();

protected:
    void showDraft(const ExerciseDraft& draft) override;

private:
    QLineEdit* addText(const char* name, const QString& label, std::string Exercise::*text);
    void addBurs();
    void addRules();
    void addJudgement();
    void showBurs(const Exercise& exercise);
    void showRules(const Exercise& exercise);

    QLineEdit* name_;
    QLineEdit* task_;
    QLineEdit* brief_;
    QComboBox* bur_ = nullptr;
    QListWidget* otherBurs_ = nullptr;
    QCheckBox* onlyTheseBurs_ = nullptr;
    QListWidget* instruments_ = nullptr;
    QComboBox* group_ = nullptr;
    QComboBox* level_ = nullptr;
    QDoubleSpinBox* minutes_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    QComboBox* rubric_ = nullptr;
};

}  // namespace tactooth

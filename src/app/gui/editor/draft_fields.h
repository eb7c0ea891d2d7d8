// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>

#include "app/gui/editor/exercise_draft.h"

namespace tactooth {

/// Some fields of the editor's panel, with a heading. They show a draft, and ask for changes of it.
class DraftFields : public QGroupBox {
    Q_OBJECT

public:
    explicit DraftFields(const QString& title) : QGroupBox(title) {
        form_ = new QFormLayout(this);
        form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    }

    /// Asks for no change.
    void show(const ExerciseDraft& draft) {
        isShowing_ = true;
        showDraft(draft);
        isShowing_ = false;
    }

signals:
    /// The user wants to change the draft; `step`: as for ExerciseDraft::change.
    void edited(const QString& step, const ExerciseChange& change);

protected:
    virtual void showDraft(const ExerciseDraft& draft) = 0;
    void ask(const QString& step, const ExerciseChange& change) {
        if (!isShowing_) emit edited(step, change);
    }
    [[nodiscard]] QFormLayout& form() const { return *form_; }

    /// A number with its row. `name`: by which tests find it, and the step of its changes.
    struct Range {
        double low, high, step;
        int decimals;
        QString unit;  ///< begins with a space
    };
    QDoubleSpinBox* addNumber(const char* name, const QString& label, const Range& range,
                              std::function<void(Exercise&, double)> set);
    /// The same for a choice; `set` gets the number of the entry.
    QComboBox* addChoice(const char* name, const QString& label, const QStringList& entries,
                         std::function<void(Exercise&, int)> set);

private:
    QFormLayout* form_;
    bool isShowing_ = false;
};

}  // namespace tactooth

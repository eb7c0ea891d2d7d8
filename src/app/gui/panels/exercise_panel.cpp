// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/exercise_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/text/translation.h"
#include "assessment/exercise.h"
#include "tooth/model/material_word.h"

namespace tactooth {
namespace {

constexpr int kPercent = 100;

QToolButton* button(const QString& text, const QString& tip, const char* name) {
    auto* result = new QToolButton;
    result->setText(text);
    result->setToolTip(tip);
    result->setObjectName(name);
    return result;
}

}  // namespace

ExercisePanel::ExercisePanel(QWidget* parent)
    : QWidget(parent), exercises_(new QComboBox), task_(new QLabel), cleared_(new QProgressBar) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    row->setSpacing(16);
    row->addWidget(makeChoice(), 1);
    row->addWidget(makeNumbers(), 1);
    show(nullptr);
    show(0, {}, {});
}

QWidget* ExercisePanel::makeChoice() {
    exercises_->setObjectName("exercise");
    exercises_->setAccessibleName(tr("Exercise"));
    exercises_->setToolTip(tr("What to practise: brings the tooth, the bur and the ghost of the ideal cavity"));
    exercises_->addItem(tr("Free practice"));
    known_.emplace_back();
    for (const auto& exercise : exercises()) {
        exercises_->addItem(translated(exercise->name));
        known_.push_back(exercise);
    }
    connect(exercises_, &QComboBox::activated, this,
            [this](int index) { emit chosen(known_[static_cast<std::size_t>(index)]); });
    task_->setWordWrap(true);
    task_->setObjectName("task");
    auto* again =
        button(tr("Start again"), tr("The whole tooth again, and the time from its first contact"), "startAgain");
    auto* report = button(tr("Report…"), tr("Writes time, volumes and what happened as a table (CSV)"), "exportReport");
    auto* open = button(tr("Open…"), tr("An exercise of your own: a TOML file (docs/exercises.md)"), "openExercise");
    connect(open, &QToolButton::clicked, this, &ExercisePanel::openRequested);
    connect(again, &QToolButton::clicked, this, &ExercisePanel::restartRequested);
    connect(report, &QToolButton::clicked, this, &ExercisePanel::exportRequested);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(again);
    buttons->addWidget(report);
    buttons->addWidget(open);
    buttons->addStretch();
    auto* choice = new QWidget;
    auto* column = new QVBoxLayout(choice);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(exercises_);
    column->addWidget(task_, 1);
    column->addLayout(buttons);
    return choice;
}

QWidget* ExercisePanel::makeNumbers() {
    const std::array<std::pair<QString, QString>, kMetricCount> facts = {
        {{tr("Time"), tr("Since the first contact")},
         {tr("Cut beyond"), tr("Volume that was cut outside of the ideal cavity")},
         {tr("Deepest beyond"), tr("How far the cut goes beyond the ideal walls at its worst")},
         {tr("Likeness"), tr("Twice what your cavity and the ideal one have in common over the sum of both: 100 % is "
                             "the ideal cavity, no more and no less")}}};
    auto* numbers = new QWidget;
    auto* grid = new QGridLayout(numbers);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(1);
    cleared_->setObjectName("cleared");
    cleared_->setAccessibleName(tr("Share of the ideal cavity that is cut"));
    cleared_->setToolTip(cleared_->accessibleName());
    cleared_->setRange(0, kPercent);
    grid->addWidget(cleared_, 0, 0, 1, 4);
    for (int fact = 0; fact < kMetricCount; ++fact) {
        const auto& [name, tip] = facts[static_cast<std::size_t>(fact)];
        auto* title = new QLabel(name);
        title->setToolTip(tip);
        auto* value = values_[static_cast<std::size_t>(fact)] = new QLabel;
        value->setAccessibleName(name);
        value->setToolTip(tip);
        grid->addWidget(title, fact + 1, 0);
        grid->addWidget(value, fact + 1, 1, Qt::AlignRight);
    }
    // Those that a tooth is made of first; the others would be a column of zeros.
    int row = 1;
    for (const MaterialId id : {MaterialId::Enamel, MaterialId::Dentin, MaterialId::Caries, MaterialId::Pulp}) {
        const QString name = translated(materialWord(materialName(id)));
        auto* value = removed_[static_cast<std::size_t>(id)] = new QLabel;
        value->setAccessibleName(tr("%1 removed").arg(name));
        grid->addWidget(new QLabel(name), row, 2);
        grid->addWidget(value, row++, 3, Qt::AlignRight);
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    grid->setRowStretch(row, 1);
    return numbers;
}

QString ExercisePanel::number(double value, int digits) const { return locale().toString(value, 'f', digits); }

void ExercisePanel::show(const std::shared_ptr<const Exercise>& exercise) {
    const auto isSame = [&](const auto& known) {
        return known == exercise || (known && exercise && !known->file.empty() && known->file == exercise->file);
    };
    auto place = std::find_if(known_.begin(), known_.end(), isSame);
    if (place == known_.end()) {
        place = known_.insert(place, exercise);
        exercises_->addItem(QString());
    }
    const auto index = static_cast<int>(place - known_.begin());
    if (exercise != nullptr) exercises_->setItemText(index, translated(exercise->name));
    *place = exercise;
    exercises_->setCurrentIndex(index);
    task_->setText(exercise != nullptr ? translated(exercise->task)
                                       : tr("Choose an exercise, or a target of your own under Look inside."));
}

void ExercisePanel::show(double seconds, const MaterialVolumes& removed, const std::optional<CavityProgress>& cavity) {
    const int whole = static_cast<int>(seconds);
    values_[kTime]->setText(QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0')));
    for (std::size_t id = 0; id < kMaterialCount; ++id) {
        if (removed_[id] != nullptr) removed_[id]->setText(tr("%1 mm³").arg(number(removed[id], 2)));
    }
    cleared_->setEnabled(cavity.has_value());
    cleared_->setValue(cavity ? static_cast<int>(std::floor(kPercent * cavity->clearedFraction())) : 0);
    cleared_->setFormat(cavity ? tr("%p % of the cavity") : tr("no ideal cavity"));
    const QString none = QStringLiteral("–");
    values_[kOverPreparation]->setText(cavity ? tr("%1 mm³").arg(number(cavity->beyond, 2)) : none);
    values_[kMaxOverPreparation]->setText(cavity ? tr("%1 mm").arg(number(cavity->maxOverPreparation, 2)) : none);
    values_[kDice]->setText(cavity ? tr("%1 %").arg(number(kPercent * cavity->dice(), 0)) : none);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/exercise_panel.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QStandardItemModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/text/translation.h"
#include "assessment/exercise.h"
#include "assessment/rubric/exercise_rubric.h"

namespace tactooth {
namespace {

constexpr int kPercent = 100;
constexpr int kMostRows = 30;  // of the list without scrolling

/// The title with its level.
QString titleInList(const Exercise& exercise) {
    const QString title = exerciseTitle(exercise);
    if (exercise.group == ExerciseGroup::Own) return title;  // nobody has said how hard it is
    return QString("%1 (%2)").arg(title, translated(titleOf(exercise.level)));
}

ExerciseGroup headingOf(const Exercise& exercise) { return exercise.id.empty() ? ExerciseGroup::Own : exercise.group; }

/// Task and brief.
QString textOf(const Exercise& exercise) {
    const ExerciseWords words = exercise.words(windowLanguage());
    return QString::fromStdString(words.brief.empty() ? words.task : words.task + ' ' + words.brief);
}

QToolButton* button(const QString& text, const QString& tip, const char* name) {
    auto* result = new QToolButton;
    result->setText(text);
    result->setToolTip(tip);
    result->setObjectName(name);
    return result;
}

}  // namespace

ExercisePanel::ExercisePanel(QWidget* parent)
    : QWidget(parent),
      exercises_(new QComboBox),
      task_(new QLabel),
      cleared_(new QProgressBar),
      finish_(new QAction(this)),
      materials_(&builtinMaterials()) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    row->setSpacing(16);
    row->addWidget(makeChoice(), 1);
    row->addWidget(makeNumbers(), 1);
    showFinish({}, false);
    show(nullptr);
    show(0, {}, *materials_, {});
}

QWidget* ExercisePanel::makeChoice() {
    exercises_->setObjectName("exercise");
    exercises_->setAccessibleName(tr("Exercise"));
    exercises_->setToolTip(tr("What to practise: brings the tooth, the bur and the ghost of the ideal cavity"));
    exercises_->setMaxVisibleItems(kMostRows);
    exercises_->addItem(tr("Free practice"), 0);
    known_.emplace_back();
    for (const auto& exercise : exercises()) addToList(exercise);
    connect(exercises_, &QComboBox::activated, this,
            [this](int index) { emit chosen(known_[static_cast<std::size_t>(exercises_->itemData(index).toInt())]); });
    task_->setWordWrap(true);
    task_->setObjectName("task");
    again_ = button(tr("Start again"), tr("The whole tooth again, and the time from its first contact"), "startAgain");
    report_ = button(tr("Report…"), tr("Writes time, volumes and what happened as a table (CSV)"), "exportReport");
    auto* open = button(tr("Open…"), tr("An exercise of your own: a TOML file (docs/exercises.md)"), "openExercise");
    connect(open, &QToolButton::clicked, this, &ExercisePanel::openRequested);
    connect(again_, &QToolButton::clicked, this, &ExercisePanel::restartRequested);
    connect(report_, &QToolButton::clicked, this, &ExercisePanel::exportRequested);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(makeFinishButton());
    buttons->addWidget(again_);
    buttons->addWidget(report_);
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

/// The largest button of the panel.
QToolButton* ExercisePanel::makeFinishButton() {
    finish_->setObjectName("finishExercise");
    setLineIcon(*finish_, "finish");
    bindKey(*finish_, KeyId::Finish);
    auto* result = new QToolButton;
    result->setObjectName("finish");
    result->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    result->setDefaultAction(finish_);
    QFont bold = font();
    bold.setBold(true);
    result->setFont(bold);
    constexpr double kTall = 1.7;  // lines of text
    result->setMinimumHeight(static_cast<int>(kTall * fontMetrics().height()));
    return result;
}

void ExercisePanel::showFinish(const QString& obstacle, bool isStopped) {
    finish_->setText(isStopped ? tr("&Continue exercise") : tr("&Finish exercise"));
    finish_->setIconText(isStopped ? tr("Continue") : tr("Finish"));
    finish_->setEnabled(obstacle.isEmpty());
    const QString what = isStopped ? tr("The time of the exercise goes on")
                                   : tr("The time stops, and the report shows the mark and what it is made of");
    finish_->setToolTip(QString("%1 (%2)").arg(obstacle.isEmpty() ? what : obstacle, keyOf(*finish_)));
}

/// Those from files are the user's own, whatever they train.
void ExercisePanel::addToList(const std::shared_ptr<const Exercise>& exercise) {
    const bool isNewGroup = known_.back() == nullptr || headingOf(*known_.back()) != headingOf(*exercise);
    if (isNewGroup) {
        exercises_->addItem(translated(titleOf(headingOf(*exercise))));
        auto* heading = qobject_cast<QStandardItemModel*>(exercises_->model())->item(exercises_->count() - 1);
        heading->setFlags(Qt::NoItemFlags);
        QFont bold = exercises_->font();
        bold.setBold(true);
        heading->setFont(bold);
    }
    exercises_->addItem(titleInList(*exercise), static_cast<int>(known_.size()));
    known_.push_back(exercise);
}

int ExercisePanel::rowOf(std::size_t known) const { return exercises_->findData(static_cast<int>(known)); }

QWidget* ExercisePanel::makeNumbers() {
    auto* numbers = new QWidget;
    auto* grid = numbers_ = new QGridLayout(numbers);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(1);
    cleared_->setObjectName("cleared");
    cleared_->setAccessibleName(tr("Share of the ideal cavity that is cut"));
    cleared_->setToolTip(cleared_->accessibleName());
    cleared_->setRange(0, kPercent);
    grid->addWidget(cleared_, 0, 0, 1, 4);
    int row = 0;
    time_ = addFact(*grid, ++row, tr("Time"), tr("Since the first contact"));
    for (const Metric& metric : metricTable()) {
        if (metric.titleEn.empty()) continue;
        metrics_.emplace_back(&metric, addFact(*grid, ++row, inWindowLanguage(metric.titleEn, metric.titleJa),
                                               inWindowLanguage(metric.tipEn, metric.tipJa)));
    }
    // The main materials of a tooth; each other material gets a row when some of it is removed.
    for (const MaterialRole role :
         {MaterialRole::Enamel, MaterialRole::Dentin, MaterialRole::Decay, MaterialRole::Pulp})
        static_cast<void>(rowOf(materials_->withRole(role)));
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    return numbers;
}

QLabel* ExercisePanel::addFact(QGridLayout& grid, int row, const QString& title, const QString& tip) {
    auto* label = new QLabel(title);
    label->setToolTip(tip);
    auto* value = new QLabel;
    value->setAccessibleName(title);
    value->setToolTip(tip);
    grid.addWidget(label, row, 0);
    grid.addWidget(value, row, 1, Qt::AlignRight);
    return value;
}

ExercisePanel::RemovedRow& ExercisePanel::rowOf(MaterialId id) {
    RemovedRow& row = removed_[static_cast<std::size_t>(id)];
    if (row.value != nullptr) return row;
    row = {new QLabel, new QLabel};
    numbers_->setRowStretch(++removedRows_, 0);
    numbers_->addWidget(row.title, removedRows_, 2);
    numbers_->addWidget(row.value, removedRows_, 3, Qt::AlignRight);
    numbers_->setRowStretch(removedRows_ + 1, 1);
    setTitle(row, id);
    showNumbers();
    return row;
}

void ExercisePanel::setTitle(RemovedRow& row, MaterialId id) {
    const QString title = materialTitle((*materials_)[id]);
    row.title->setText(title);
    row.value->setAccessibleName(tr("%1 removed").arg(title));
}

void ExercisePanel::setShowsNumbers(bool shows) {
    showsNumbers_ = shows;
    report_->setEnabled(shows);
    showNumbers();
}

void ExercisePanel::setAllowsRestart(bool allows) { again_->setEnabled(allows); }

/// All that the grid holds but the time.
void ExercisePanel::showNumbers() {
    constexpr int kTimeRow = 1;
    for (int i = 0; i < numbers_->count(); ++i) {
        int row = 0, column = 0, rows = 0, columns = 0;
        numbers_->getItemPosition(i, &row, &column, &rows, &columns);
        const bool isTime = row == kTimeRow && column < 2;
        if (!isTime) numbers_->itemAt(i)->widget()->setVisible(showsNumbers_);
    }
    for (std::size_t i = materials_->size(); i < removed_.size(); ++i) {  // of another tooth
        if (removed_[i].value == nullptr) continue;
        removed_[i].title->hide();
        removed_[i].value->hide();
    }
}

/// Another tooth may have other materials.
void ExercisePanel::setMaterials(const MaterialRegistry& materials) {
    if (&materials == materials_) return;
    materials_ = &materials;
    for (std::size_t i = 0; i < removed_.size(); ++i) {
        RemovedRow& row = removed_[i];
        if (row.value == nullptr) continue;
        const bool isKnown = i < materials.size();
        row.title->setVisible(isKnown && showsNumbers_);
        row.value->setVisible(isKnown && showsNumbers_);
        if (isKnown) setTitle(row, static_cast<MaterialId>(i));
    }
}

QString ExercisePanel::number(double value, int digits) const { return locale().toString(value, 'f', digits); }

std::size_t ExercisePanel::placeOf(const std::shared_ptr<const Exercise>& exercise) {
    const auto isSame = [&](const auto& known) {
        return known == exercise || (known && exercise && !known->file.empty() && known->file == exercise->file);
    };
    auto place = std::find_if(known_.begin(), known_.end(), isSame);
    if (place == known_.end()) {
        addToList(exercise);
        place = known_.end() - 1;
    }
    *place = exercise;
    const auto number = static_cast<std::size_t>(place - known_.begin());
    if (exercise != nullptr) exercises_->setItemText(rowOf(number), titleInList(*exercise));
    return number;
}

void ExercisePanel::add(const std::shared_ptr<const Exercise>& exercise) { placeOf(exercise); }

void ExercisePanel::remove(const std::shared_ptr<const Exercise>& exercise) {
    const auto place = std::find(known_.begin(), known_.end(), exercise);
    if (exercise == nullptr || exercise == active_ || place == known_.end()) return;
    const auto number = static_cast<int>(place - known_.begin());
    int row = rowOf(static_cast<std::size_t>(number));
    exercises_->removeItem(row);
    const bool wasAlone = !exercises_->itemData(row - 1).isValid() &&
                          (row == exercises_->count() || !exercises_->itemData(row).isValid());
    if (wasAlone) exercises_->removeItem(--row);  // its heading
    for (; row < exercises_->count(); ++row) {
        if (exercises_->itemData(row).isValid()) exercises_->setItemData(row, exercises_->itemData(row).toInt() - 1);
    }
    known_.erase(place);
}

void ExercisePanel::show(const std::shared_ptr<const Exercise>& exercise) {
    const std::size_t number = placeOf(exercise);
    active_ = exercise;
    exercises_->setCurrentIndex(rowOf(number));
    task_->setText(exercise != nullptr ? textOf(*exercise)
                                       : tr("Choose an exercise, or a target of your own under Look inside."));
    task_->setToolTip(exercise != nullptr ? markedBy(*exercise) : QString());
}

/// Empty for a rubric from a file that cannot be read any more.
QString ExercisePanel::markedBy(const Exercise& exercise) {
    const Expected<Rubric> rubric = rubricOf(exercise);
    return rubric ? tr("Marked by the rubric: %1").arg(QString::fromStdString(rubric->nameIn(windowLanguage())))
                  : QString();
}

void ExercisePanel::show(double seconds, const MaterialVolumes& removed, const MaterialRegistry& materials,
                         const std::optional<CavityProgress>& cavity) {
    const int whole = static_cast<int>(seconds);
    const QString worked = QString("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QChar('0'));
    const bool hasLimit = active_ != nullptr && active_->minutes;
    time_->setText(hasLimit ? tr("%1 of %2:00").arg(worked).arg(*active_->minutes) : worked);
    setMaterials(materials);
    for (const MaterialId id : materials.ids()) {
        const double volume = removed[static_cast<std::size_t>(id)];
        const bool isShown = volume > 0 || removed_[static_cast<std::size_t>(id)].value != nullptr;
        if (isShown) rowOf(id).value->setText(tr("%1 mm³").arg(number(volume, 2)));
    }
    cleared_->setEnabled(cavity.has_value());
    cleared_->setValue(cavity ? static_cast<int>(std::floor(kPercent * cavity->clearedFraction())) : 0);
    cleared_->setFormat(cavity ? tr("%p % of the cavity") : tr("no ideal cavity"));
    for (const auto& [metric, label] : metrics_) {
        if (!cavity) {
            label->setText(QStringLiteral("–"));
            continue;
        }
        const QString unit = QString::fromUtf8(metric->shownUnit()).replace("^3", "³");
        label->setText(number(metric->shown(*cavity), metric->isFraction() ? 0 : 2) + ' ' + unit);
    }
}

}  // namespace tactooth

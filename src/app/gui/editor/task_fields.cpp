// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/editor/task_fields.h"

#include <algorithm>

#include "app/gui/text/translation.h"
#include "assessment/allowed_instruments.h"
#include "assessment/exercise_keys.h"
#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

constexpr int kLongestText = 500;  // letters: a line of a file has 2000 bytes
constexpr int kRows = 4;           // of a list without scrolling

void setText(QLineEdit& line, const std::string& text) {
    const QString shown = QString::fromStdString(text);
    if (line.text() != shown) line.setText(shown);  // else the cursor would jump
}

QString titleOf(const TrayInstrument& instrument) {
    if (const auto* hand = std::get_if<HandInstrument>(&instrument)) return translated(*specOf(*hand).title);
    const auto drive = std::ranges::find(spindlePresets(), std::get<HandpieceKind>(instrument),
                                         [](const SpindlePreset& each) { return handpieceOf(each); });
    return translated(drive->name);
}

}  // namespace

TaskFields::TaskFields() : DraftFields(tr("Task")) {
    name_ = addText("editName", tr("Name"), &Exercise::name);
    task_ = addText("editTask", tr("Task"), &Exercise::task);
    brief_ = addText("editBrief", tr("How to do it"), &Exercise::brief);
    addBurs();
    addRules();
    addJudgement();
}

QLineEdit* TaskFields::addText(const char* name, const QString& label, std::string Exercise::*text) {
    auto* line = new QLineEdit;
    line->setObjectName(name);
    line->setAccessibleName(label);
    line->setMaxLength(kLongestText);
    form().addRow(label, line);
    connect(line, &QLineEdit::textEdited, this, [this, step = QString(name), text](const QString& now) {
        ask(step, [text, words = now.toStdString()](Exercise& exercise) { exercise.*text = words; });
    });
    return line;
}

void TaskFields::addBurs() {
    QStringList titles;
    for (const BurSpec& bur : burCatalogue()) titles << translated(bur.title);
    bur_ = addChoice("editBur", tr("Bur"), titles, [](Exercise& exercise, int entry) {
        if (entry >= 0) takeBur(exercise, burCatalogue()[static_cast<std::size_t>(entry)]);
    });
    otherBurs_ = new QListWidget;
    otherBurs_->setObjectName("editOtherBurs");
    otherBurs_->setAccessibleName(tr("Other burs"));
    otherBurs_->setToolTip(tr("Burs that serve as well"));
    for (const QString& title : titles) {
        auto* item = new QListWidgetItem(title, otherBurs_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(Qt::Unchecked);
    }
    otherBurs_->setMaximumHeight(kRows * (otherBurs_->sizeHintForRow(0) + 2));
    form().addRow(tr("Other burs"), otherBurs_);
    connect(otherBurs_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        const std::string number = burCatalogue()[static_cast<std::size_t>(otherBurs_->row(item))].number;
        ask({}, [number, on = item->checkState() == Qt::Checked](Exercise& exercise) {
            std::erase(exercise.otherBurs, number);
            if (on) exercise.otherBurs.push_back(number);
        });
    });
}

/// What the student may take.
void TaskFields::addRules() {
    onlyTheseBurs_ = new QCheckBox(tr("Only these burs"));
    onlyTheseBurs_->setObjectName("editOnlyTheseBurs");
    onlyTheseBurs_->setToolTip(tr("The student may take no other bur"));
    form().addRow(QString(), onlyTheseBurs_);
    connect(onlyTheseBurs_, &QCheckBox::toggled, this,
            [this](bool on) { ask({}, [on](Exercise& exercise) { exercise.onlyTheseBurs = on; }); });
    instruments_ = new QListWidget;
    instruments_->setObjectName("editInstruments");
    instruments_->setAccessibleName(tr("Instruments"));
    instruments_->setToolTip(tr("What the student may take from the tray; one handpiece at least"));
    for (const auto& [key, instrument] : kInstrumentKeys) {
        auto* item = new QListWidgetItem(titleOf(instrument), instruments_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(Qt::Checked);
    }
    instruments_->setMaximumHeight(kRows * (instruments_->sizeHintForRow(0) + 2));
    form().addRow(tr("Instruments"), instruments_);
    connect(instruments_, &QListWidget::itemChanged, this, [this] {
        std::vector<TrayInstrument> chosen;
        for (std::size_t i = 0; i < kInstrumentKeys.size(); ++i) {
            const bool isOn = instruments_->item(static_cast<int>(i))->checkState() == Qt::Checked;
            if (isOn) chosen.push_back(kInstrumentKeys.at(i).second);
        }
        if (chosen.size() == kInstrumentKeys.size()) chosen.clear();  // all
        ask({}, [chosen](Exercise& exercise) { exercise.instruments = chosen; });
    });
}

void TaskFields::showRules(const Exercise& exercise) {
    onlyTheseBurs_->setChecked(exercise.onlyTheseBurs);
    const auto isHandpiece = [](const TrayInstrument& each) { return std::holds_alternative<HandpieceKind>(each); };
    const bool isLast = std::ranges::count_if(exercise.instruments, isHandpiece) == 1;
    for (std::size_t i = 0; i < kInstrumentKeys.size(); ++i) {
        const TrayInstrument& instrument = kInstrumentKeys.at(i).second;
        QListWidgetItem& item = *instruments_->item(static_cast<int>(i));
        const bool isOn = allows(exercise, instrument);
        item.setCheckState(isOn ? Qt::Checked : Qt::Unchecked);
        const bool mustStay = isOn && isLast && isHandpiece(instrument);  // without a handpiece nobody cuts
        item.setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable |
                      (mustStay ? Qt::ItemFlags() : Qt::ItemIsUserCheckable));
    }
}

void TaskFields::addJudgement() {
    QStringList groups, levels, rubrics = {tr("The usual one")};
    for (std::size_t i = 0; i < kGroupKeys.size(); ++i) groups << translated(titleOf(static_cast<ExerciseGroup>(i)));
    for (std::size_t i = 0; i < kLevelKeys.size(); ++i) levels << translated(titleOf(static_cast<ExerciseLevel>(i)));
    for (const BuiltinRubricText& text : builtinRubricTexts()) {
        const Expected<Rubric> rubric = findRubric(text.name);
        rubrics << (rubric ? QString::fromStdString(rubric->nameIn(windowLanguage())) : QString(text.name));
    }
    group_ = addChoice("editGroup", tr("Kind"), groups,
                       [](Exercise& exercise, int entry) { exercise.group = static_cast<ExerciseGroup>(entry); });
    level_ = addChoice("editLevel", tr("Level"), levels,
                       [](Exercise& exercise, int entry) { exercise.level = static_cast<ExerciseLevel>(entry); });
    minutes_ =
        addNumber("editMinutes", tr("Time"), {0, kMostMinutes, 1, 0, tr(" min")}, [](Exercise& exercise, double value) {
            exercise.minutes.reset();
            if (value > 0) exercise.minutes = static_cast<int>(value);
        });
    minutes_->setSpecialValueText(tr("no limit"));
    tolerance_ = addNumber("editTolerance", tr("Tolerance"), {kLeastTolerance, kMostTolerance, 0.05, 2, tr(" mm")},
                           [](Exercise& exercise, double value) { exercise.tolerance = value; });
    rubric_ = addChoice("editRubric", tr("Rubric"), rubrics, [](Exercise& exercise, int entry) {
        if (entry < 0) return;  // one from a file stays
        exercise.rubric = entry == 0 ? "" : builtinRubricTexts()[static_cast<std::size_t>(entry) - 1].name;
    });
}

void TaskFields::showBurs(const Exercise& exercise) {
    const auto* number = std::get_if<std::string>(&exercise.bur);
    bur_->setEnabled(number != nullptr);
    const auto& burs = burCatalogue();
    for (std::size_t i = 0; i < burs.size(); ++i) {
        const auto row = static_cast<int>(i);
        const bool isIt = number != nullptr && burs[i].number == *number;
        if (isIt) bur_->setCurrentIndex(row);
        const bool serves = std::ranges::find(exercise.otherBurs, burs[i].number) != exercise.otherBurs.end();
        otherBurs_->item(row)->setCheckState(serves ? Qt::Checked : Qt::Unchecked);
        otherBurs_->item(row)->setHidden(isIt);
    }
}

void TaskFields::showDraft(const ExerciseDraft& draft) {
    const Exercise& exercise = draft.exercise();
    setText(*name_, exercise.name);
    setText(*task_, exercise.task);
    setText(*brief_, exercise.brief);
    showBurs(exercise);
    showRules(exercise);
    group_->setCurrentIndex(static_cast<int>(exercise.group));
    level_->setCurrentIndex(static_cast<int>(exercise.level));
    minutes_->setValue(exercise.minutes.value_or(0));
    tolerance_->setValue(exercise.tolerance);
    int rubric = exercise.rubric.empty() ? 0 : -1;
    for (std::size_t i = 0; i < builtinRubricTexts().size(); ++i) {
        if (exercise.rubric == builtinRubricTexts()[i].name) rubric = static_cast<int>(i) + 1;
    }
    rubric_->setCurrentIndex(rubric);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/setting_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "app/gui/settings/messages.h"
#include "app/gui/text/language_names.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

struct Word {
    const char* word;
    const MessageText* text;
};
constexpr std::array kWords = {Word{"fit", &msg::kSettingsWordFit},
                               Word{"occlusal", &msg::kSettingsWordOcclusal},
                               Word{"buccal", &msg::kSettingsWordBuccal},
                               Word{"lingual", &msg::kSettingsWordLingual},
                               Word{"mesial", &msg::kSettingsWordMesial},
                               Word{"distal", &msg::kSettingsWordDistal},
                               Word{"none", &msg::kSettingsWordNone},
                               Word{kMouseToDepth, &msg::kSettingsWordDepth},
                               Word{kMouseByForce, &msg::kSettingsWordForce},
                               Word{"fdi", &msg::kSettingsWordFdi},
                               Word{"universal", &msg::kSettingsWordUniversal},
                               Word{"palmer", &msg::kSettingsWordPalmer}};

/// A word of the settings as the user reads it; numbers stay as they are.
QString shownWord(const QString& word) {
    const auto* const known =
        std::ranges::find_if(kWords, [&](const Word& each) { return word == QString(each.word); });
    if (known != kWords.end()) return translated(*known->text);
    const std::vector<LanguageName> languages = languageNames();
    const auto language = std::ranges::find(languages, word, &LanguageName::code);
    return language != languages.end() ? language->title : word;
}

/// So that a step is felt and the range is not endless.
std::pair<double, int> stepAndDecimals(const WindowOption& option) {
    if (option.isCount) return {1, 0};
    if (option.highest <= 0.1) return {0.001, 4};
    if (option.lowest >= 100) return {100, 0};
    if (option.highest > 100) return {1, 1};
    return {option.highest <= 1 ? 0.05 : 0.1, 2};
}

SettingChoices wordsOf(const WindowOption& option) {
    SettingChoices result;
    if (option.empty != nullptr) result.emplace_back(translated(*option.empty), QString());
    for (const QString& word : QString(option.words).split(", ")) result.emplace_back(shownWord(word), word);
    return result;
}

}  // namespace

SettingRow::SettingRow(const WindowOption& option, const SettingChoices& choices, QGridLayout& grid) : option_(option) {
    QWidget* control = nullptr;
    if (const auto* on = std::get_if<WindowOption::Switch>(&option.value)) {
        control = makeSwitch(*on);
    } else if (const auto* number = std::get_if<WindowOption::Number>(&option.value)) {
        control = makeNumber(*number);
    } else if (option.words != nullptr || !choices.empty()) {
        control =
            makeChoice(std::get<WindowOption::Text>(option.value), option.words != nullptr ? wordsOf(option) : choices);
    } else {
        control = makeText(std::get<WindowOption::Text>(option.value));
    }
    control->setObjectName(QString::fromStdString(flagOf(option)));
    control->setAccessibleName(translated(*option.help));
    auto* what = new QLabel(translated(*option.help));
    what->setWordWrap(true);
    what->setBuddy(control);
    auto* usual = new QLabel(usualText_.isEmpty() ? QString() : tr("usually %1").arg(usualText_));
    usual->setEnabled(false);  // grey
    const int row = grid.rowCount();
    grid.addWidget(what, row, 0);
    grid.addWidget(control, row, 1);
    grid.addWidget(usual, row, 2);
}

void SettingRow::show(WindowSettings settings) { show_(settings); }

void SettingRow::showUsual() { show(WindowSettings()); }

QWidget* SettingRow::makeSwitch(WindowOption::Switch value) {
    auto* box = new QCheckBox;
    WindowSettings usual;
    usualText_ = translated(value(usual) ? msg::kSettingsWordOn : msg::kSettingsWordOff);
    show_ = [box, value](WindowSettings& settings) {
        const QSignalBlocker quiet(box);
        box->setChecked(value(settings));
    };
    store_ = [box, value](WindowSettings& settings) { value(settings) = box->isChecked(); };
    connect(box, &QCheckBox::toggled, this, &SettingRow::changed);
    return box;
}

/// A word for zero has the place below the lowest number.
QWidget* SettingRow::makeNumber(WindowOption::Number value) {
    auto* box = new QDoubleSpinBox;
    const auto [step, decimals] = stepAndDecimals(option_);
    const bool hasWord = option_.zero != nullptr;
    const double below = option_.lowest - step;
    box->setDecimals(decimals);
    box->setSingleStep(step);
    box->setRange(hasWord ? below : option_.lowest, option_.highest);
    box->setKeyboardTracking(false);
    if (option_.unit != nullptr) box->setSuffix(QString(" ") + option_.unit);
    if (hasWord) box->setSpecialValueText(shownWord(option_.zero));
    show_ = [box, value, hasWord, below](WindowSettings& settings) {
        const QSignalBlocker quiet(box);
        box->setValue(hasWord && value(settings) == 0 ? below : value(settings));
    };
    store_ = [box, value, hasWord](WindowSettings& settings) {
        value(settings) = hasWord && box->value() == box->minimum() ? 0 : box->value();
    };
    showUsual();
    usualText_ = box->text();
    connect(box, &QDoubleSpinBox::valueChanged, this, &SettingRow::changed);
    return box;
}

QWidget* SettingRow::makeChoice(WindowOption::Text value, const SettingChoices& choices) {
    auto* box = new QComboBox;
    constexpr int kLetters = 16;  // a long name must not widen the dialog
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(kLetters);
    for (const auto& [title, word] : choices) box->addItem(title, word);
    WindowSettings usual;
    const int usually = std::max(0, box->findData(QString::fromStdString(value(usual))));
    usualText_ = box->itemText(usually);
    // A text that is no choice, as the number of a bur from a file, is shown by no entry, and stays.
    show_ = [box, value, usually](WindowSettings& settings) {
        const QSignalBlocker quiet(box);
        WindowSettings defaults;
        const bool isUsual = value(settings) == value(defaults);
        box->setCurrentIndex(isUsual ? usually : box->findData(QString::fromStdString(value(settings))));
    };
    store_ = [box, value](WindowSettings& settings) {
        if (box->currentIndex() >= 0) value(settings) = box->currentData().toString().toStdString();
    };
    connect(box, &QComboBox::currentIndexChanged, this, &SettingRow::changed);
    return box;
}

QWidget* SettingRow::makeText(WindowOption::Text value) {
    auto* line = new QLineEdit;
    WindowSettings usual;
    usualText_ = QString::fromStdString(value(usual));
    show_ = [line, value](WindowSettings& settings) { line->setText(QString::fromStdString(value(settings))); };
    store_ = [line, value](WindowSettings& settings) { value(settings) = line->text().trimmed().toStdString(); };
    connect(line, &QLineEdit::editingFinished, this, &SettingRow::changed);
    return line;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/welcome_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "app/gui/dialogs/card_list.h"
#include "app/gui/icons/exercise_picture.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/model/recent_file.h"
#include "app/gui/model/thumbnail_store.h"
#include "app/gui/text/language_names.h"
#include "app/gui/text/translation.h"
#include "assessment/exercise.h"

namespace tactooth {
namespace {

constexpr int kColumns = 4;  // of cards: with the ways beside them, the page fits a small screen

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    font.setPointSizeF(1.15 * font.pointSizeF());
    label->setFont(font);
    return label;
}

const char* iconOf(RecentWork::Kind kind) {
    switch (kind) {
        case RecentWork::Kind::Scan:
            return "import";
        case RecentWork::Kind::Case:
            return "case";
        case RecentWork::Kind::Exercise:
            return "exercise";
        case RecentWork::Kind::Recording:
            return "recording";
        case RecentWork::Kind::Tooth:
            break;
    }
    return "tooth";
}

/// "Recording, 29 Nov 14:32".
QString factsOf(const RecentWork& work) {
    const QLocale locale;
    const QString day = work.time.date() == QDate::currentDate()
                            ? QString()
                            : locale.toString(work.time.date(), WelcomeDialog::tr("d MMM")) + ' ';
    const QString time = day + locale.toString(work.time.time(), QLocale::ShortFormat);
    switch (work.kind) {
        case RecentWork::Kind::Scan:
            return WelcomeDialog::tr("Scan, %1").arg(time);
        case RecentWork::Kind::Case:
            return WelcomeDialog::tr("Case, %1").arg(time);
        case RecentWork::Kind::Exercise:
            return WelcomeDialog::tr("Exercise, %1").arg(time);
        case RecentWork::Kind::Recording:
            return WelcomeDialog::tr("Recording, %1").arg(time);
        case RecentWork::Kind::Tooth:
            break;
    }
    return WelcomeDialog::tr("Tooth, %1").arg(time);
}

/// "easy, 10 min".
QString factsOf(const Exercise& exercise) {
    QStringList facts;
    if (exercise.group != ExerciseGroup::Own) facts << translated(titleOf(exercise.level));
    if (exercise.minutes) facts << WelcomeDialog::tr("%1 min").arg(*exercise.minutes);
    return facts.join(", ");
}

ExerciseGroup groupOf(const Exercise& exercise) { return exercise.id.empty() ? ExerciseGroup::Own : exercise.group; }

}  // namespace

WelcomeDialog::WelcomeDialog(Contents contents, QWidget* parent) : QDialog(parent), contents_(std::move(contents)) {
    setWindowTitle(tr("Welcome to Tactooth"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* row = new QHBoxLayout(this);
    row->setSpacing(18);
    row->addWidget(makeWays());
    row->addWidget(makeWork(), 1);
    findChild<QPushButton*>("practise")->setFocus();
}

QWidget* WelcomeDialog::makeWays() {
    auto* ways = new QWidget;
    auto* column = new QVBoxLayout(ways);
    column->setContentsMargins(0, 0, 0, 0);
    auto* greeting = new QLabel(tr("See, feel and hear a bur touch and cut a tooth. What would you like to do?"));
    greeting->setWordWrap(true);
    column->addWidget(greeting);
    addChoice(*column, tr("Practise"),
              tr("A lower molar with a carious lesion is ready: move the mouse over it and press."), "practise",
              nullptr);
    addChoice(*column, tr("Open my tooth"),
              tr("A scan of your own, in any unit and position: you first see what the program assumes."), "openMine",
              &WelcomeDialog::toothRequested);
    addChoice(*column, tr("Watch the demonstration"), tr("Twenty seconds: touching, cutting, taking back."),
              "demonstration", &WelcomeDialog::demonstrationRequested);
    addChoice(*column, tr("Read the manual"), tr("The first ten minutes, keys, exercises and reports; also with F1."),
              "readManual", &WelcomeDialog::manualRequested);
    column->addStretch();
    column->addWidget(makeLanguage());
    auto* atStart = new QCheckBox(tr("Show this page at each start"));
    atStart->setObjectName("welcomeAtStart");
    atStart->setChecked(contents_.comesAtStart);
    connect(atStart, &QCheckBox::toggled, this, &WelcomeDialog::comesAtStartChanged);
    column->addWidget(atStart);
    constexpr int kLetters = 34;  // for a line that is easy to read
    ways->setFixedWidth(std::max(kLetters * fontMetrics().averageCharWidth(), ways->minimumSizeHint().width()));
    return ways;
}

void WelcomeDialog::addChoice(QBoxLayout& column, const QString& title, const QString& what, const char* name,
                              void (WelcomeDialog::*requested)()) {
    auto* button = new QPushButton(title);  // the texts of a command link have one size
    button->setObjectName(name);
    button->setAccessibleDescription(what);
    button->setAutoDefault(true);
    QFont large = button->font();
    large.setBold(true);
    button->setFont(large);
    auto* words = new QLabel(what);
    words->setWordWrap(true);
    words->setIndent(8);
    column.addWidget(button);
    column.addWidget(words);
    connect(button, &QPushButton::clicked, this, [this, requested] {
        accept();
        if (requested != nullptr) emit(this->*requested)();
    });
}

QWidget* WelcomeDialog::makeLanguage() {
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    auto* mark = new QLabel;
    mark->setPixmap(lineIcon("language").pixmap(fontMetrics().height()));
    auto* languages = new QComboBox;
    languages->setObjectName("welcomeLanguage");
    languages->setAccessibleName(tr("Language"));
    for (const LanguageName& language : languageNames()) languages->addItem(language.title, language.code);
    languages->setCurrentIndex(languages->findData(contents_.language));
    connect(languages, &QComboBox::activated, this,
            [this, languages] { emit languageChosen(languages->currentData().toString()); });
    row->addWidget(mark);
    row->addWidget(languages, 1);
    return line;
}

QWidget* WelcomeDialog::makeWork() {
    auto* work = new QWidget;
    auto* column = new QVBoxLayout(work);
    column->setContentsMargins(0, 0, 0, 0);
    int height = 0;
    if (!contents_.recent.empty()) {
        CardList* recent = makeRecent();
        column->addWidget(heading(tr("Recent work")));
        column->addWidget(recent);
        height += recent->height();
    }
    CardList* exercises = makeExercises();
    column->addWidget(heading(tr("Exercises")));
    column->addWidget(exercises, 1);
    constexpr int kRows = 3;  // of exercises and their headings, before one scrolls
    work->setMinimumWidth(exercises->widthOf(kColumns));
    exercises->setMinimumHeight(exercises->heightOf(1));
    resize(sizeHint().expandedTo({0, exercises->heightOf(kRows)}));
    return work;
}

CardList* WelcomeDialog::makeRecent() {
    auto* list = new CardList(tr("Recent work"));
    list->setObjectName("recentWork");
    const ThumbnailStore thumbnails;
    for (const RecentWork& work : contents_.recent) {
        const QStringList files = RecentFile::fromText(work.file).files;
        list->addCard({.picture = QPixmap::fromImage(thumbnails.load(files.front())),
                       .icon = iconOf(work.kind),
                       .title = work.title,
                       .facts = factsOf(work),
                       .tip = files.join('\n')});
    }
    list->setFixedHeight(list->heightOf(1));
    connect(list, &CardList::taken, this, [this](int card) {
        const QString file = contents_.recent[static_cast<std::size_t>(card)].file;
        accept();
        emit fileChosen(file);
    });
    return list;
}

CardList* WelcomeDialog::makeExercises() {
    std::erase(contents_.exercises, nullptr);
    auto* list = new CardList(tr("Exercises"));
    list->setObjectName("exercises");
    const Exercise* before = nullptr;
    for (const auto& exercise : contents_.exercises) {
        if (before == nullptr || groupOf(*before) != groupOf(*exercise)) {
            list->addHeading(translated(titleOf(groupOf(*exercise))));
        }
        before = exercise.get();
        const ExerciseWords words = exercise->words(windowLanguage());
        list->addCard({.picture = exercisePicture(*exercise),
                       .icon = "exercise",
                       .title = exerciseTitle(*exercise),
                       .facts = factsOf(*exercise),
                       .tip = QString::fromStdString(words.task)});
    }
    connect(list, &CardList::taken, this, [this](int card) {
        const auto exercise = contents_.exercises[static_cast<std::size_t>(card)];
        accept();
        emit exerciseChosen(exercise);
    });
    return list;
}

}  // namespace tactooth

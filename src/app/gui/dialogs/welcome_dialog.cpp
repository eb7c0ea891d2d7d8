// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/welcome_dialog.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace tactooth {

WelcomeDialog::WelcomeDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Welcome to Tactooth"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    auto* greeting = new QLabel(tr("See, feel and hear a bur touch and cut a tooth. What would you like to do?"));
    greeting->setWordWrap(true);
    column->addWidget(greeting);
    addChoice(tr("Practise"), tr("A lower molar with a carious lesion is ready: move the mouse over it and press."),
              "practise", nullptr);
    addChoice(tr("Open my tooth"),
              tr("A scan of your own, in any unit and position: you first see what the program assumes."), "openMine",
              &WelcomeDialog::toothRequested);
    addChoice(tr("Watch the demonstration"), tr("Twenty seconds: touching, cutting, taking back."), "demonstration",
              &WelcomeDialog::demonstrationRequested);
    auto* later = new QLabel(tr("All of this is in the menus, too, and the menu Help has a manual."));
    later->setWordWrap(true);
    column->addWidget(later);
    constexpr int kLetters = 56;  // for a line that is easy to read
    const int wide = std::max(kLetters * fontMetrics().averageCharWidth(), minimumSizeHint().width());
    setMinimumWidth(wide);
    resize(wide, layout()->totalHeightForWidth(wide));  // otherwise the height would be that of a narrower dialog
}

void WelcomeDialog::addChoice(const QString& title, const QString& what, const char* name,
                              void (WelcomeDialog::*requested)()) {
    auto* button = new QPushButton(title);  // the texts of a command link have one size
    button->setObjectName(name);
    button->setAccessibleDescription(what);
    QFont large = button->font();
    large.setBold(true);
    button->setFont(large);
    auto* words = new QLabel(what);
    words->setWordWrap(true);
    words->setIndent(8);
    layout()->addWidget(button);
    layout()->addWidget(words);
    connect(button, &QPushButton::clicked, this, [this, requested] {
        accept();
        if (requested != nullptr) emit(this->*requested)();
    });
}

}  // namespace tactooth

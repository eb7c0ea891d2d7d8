// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/welcome_dialog.h"

#include <QCommandLinkButton>
#include <QLabel>
#include <QVBoxLayout>

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
    addChoice(tr("Open my tooth"), tr("An STL file of your own, in millimetres, with the crown up."), "openMine",
              &WelcomeDialog::toothWanted);
    addChoice(tr("Watch the demonstration"), tr("Twenty seconds: touching, cutting, taking back."), "demonstration",
              &WelcomeDialog::demonstrationWanted);
    auto* later = new QLabel(tr("All of this is in the menus, too; F1 shows mouse and keys."));
    later->setWordWrap(true);
    column->addWidget(later);
    setMinimumWidth(440);
}

void WelcomeDialog::addChoice(const QString& title, const QString& what, const char* name,
                              void (WelcomeDialog::*wanted)()) {
    auto* button = new QCommandLinkButton(title, what);
    button->setObjectName(name);
    layout()->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, wanted] {
        accept();
        if (wanted != nullptr) emit(this->*wanted)();
    });
}

}  // namespace tactooth

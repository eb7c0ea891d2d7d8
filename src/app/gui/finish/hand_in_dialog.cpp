// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/hand_in_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace tactooth {

HandInDialog::HandInDialog(const QString& intro, const QString& folder, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit),
      comment_(new QPlainTextEdit),
      folder_(new QLineEdit(folder)),
      browse_(new QPushButton(tr("&Browse…"))),
      write_(new QPushButton(tr("&Hand in"))) {
    setObjectName("handIn");
    setWindowTitle(tr("Hand in"));
    setAttribute(Qt::WA_DeleteOnClose);
    name_->setObjectName("handInName");
    comment_->setObjectName("handInComment");
    comment_->setTabChangesFocus(true);
    constexpr int kLines = 4, kLetters = 60;
    comment_->setFixedHeight((kLines + 1) * fontMetrics().lineSpacing());
    folder_->setObjectName("handInFolder");
    folder_->setMinimumWidth(kLetters * fontMetrics().averageCharWidth());
    browse_->setAutoDefault(false);
    write_->setObjectName("handInWrite");
    write_->setDefault(true);
    auto* words = new QLabel(intro);
    words->setWordWrap(true);
    auto* place = new QHBoxLayout;
    place->addWidget(folder_, 1);
    place->addWidget(browse_);
    auto* form = new QFormLayout;
    form->addRow(tr("&Name of the student"), name_);
    form->addRow(tr("&Comment of the teacher"), comment_);
    auto* in = new QLabel(tr("&In the folder"));
    in->setBuddy(folder_);
    form->addRow(in, place);
    auto* buttons = new QDialogButtonBox;
    buttons->addButton(write_, QDialogButtonBox::ActionRole);
    buttons->addButton(QDialogButtonBox::Cancel);
    auto* column = new QVBoxLayout(this);
    column->addWidget(words);
    column->addLayout(form, 1);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(write_, &QPushButton::clicked, this, &HandInDialog::wanted);
    connect(browse_, &QPushButton::clicked, this, &HandInDialog::chooseFolder);
    connect(folder_, &QLineEdit::textChanged, this, &HandInDialog::follow);
    follow();
    name_->setFocus();
}

HandIn HandInDialog::handIn() const {
    return {name_->text().trimmed().toStdString(), comment_->toPlainText().trimmed().toStdString(),
            folder_->text().toStdString()};
}

void HandInDialog::setWriting(bool writing) {
    writing_ = writing;
    for (QWidget* field : std::initializer_list<QWidget*>{name_, comment_, folder_, browse_}) {
        field->setEnabled(!writing);
    }
    follow();
}

void HandInDialog::follow() { write_->setEnabled(!writing_ && !folder_->text().isEmpty()); }

void HandInDialog::chooseFolder() {
    auto* dialog = new QFileDialog(this, tr("Folder of what is handed in"), folder_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, folder_, &QLineEdit::setText);
    dialog->open();
}

}  // namespace tactooth

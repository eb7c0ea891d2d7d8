// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/bur_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"

namespace tactooth {

BurDialog::BurDialog(BurGrid* grid, QWidget* parent) : QDialog(parent), grid_(grid) {
    setObjectName("burDialog");
    setWindowTitle(tr("Burs"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeHead());
    column->addWidget(grid_, 1);
    column->addWidget(makeFoot());
    connect(grid_, &BurGrid::taken, this, &QDialog::accept);
    connect(grid_, &BurGrid::currentItemChanged, this, &BurDialog::showCurrent);
    connect(grid_, &BurGrid::favouritesChanged, this, [this] {
        if (favouritesOnly_->isChecked()) filter();
        showCurrent();
    });
    connect(grid_, &BurGrid::lettersTyped, this, [this](const QString& letters) {
        search_->setFocus();
        search_->setText(search_->text() + letters);
    });
    showCurrent();
    constexpr double kShare = 0.9;  // of the screen at most
    const int letter = fontMetrics().height();
    resize(QSize(46 * letter, 40 * letter).boundedTo(kShare * parent->screen()->availableSize()));
    grid_->setFocus();
}

QWidget* BurDialog::makeHead() {
    search_ = new QLineEdit;
    search_->setObjectName("burSearch");
    search_->setAccessibleName(tr("Search"));
    search_->setPlaceholderText(tr("Search: shape, number, ISO number or size"));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    favouritesOnly_ = new QCheckBox(tr("Fa&vourites only"));
    favouritesOnly_->setObjectName("favouritesOnly");
    connect(search_, &QLineEdit::textChanged, this, &BurDialog::filter);
    connect(favouritesOnly_, &QCheckBox::toggled, this, &BurDialog::filter);
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins({});
    row->addWidget(search_, 1);
    row->addWidget(favouritesOnly_);
    return head;
}

QWidget* BurDialog::makeFoot() {
    facts_ = new QLabel;
    facts_->setObjectName("burFacts");
    facts_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    facts_->setWordWrap(true);
    favourite_ = new QPushButton(tr("&Favourite (space)"));
    favourite_->setObjectName("favourite");
    favourite_->setCheckable(true);
    favourite_->setAutoDefault(false);  // Enter takes a bur
    connect(favourite_, &QPushButton::clicked, grid_, &BurGrid::toggleFavourite);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* foot = new QWidget;
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins({});
    row->addWidget(facts_, 1);
    row->addWidget(favourite_);
    row->addWidget(buttons);
    return foot;
}

void BurDialog::filter() { grid_->filter(search_->text(), favouritesOnly_->isChecked()); }

void BurDialog::showCurrent() {
    const BurItem* bur = grid_->currentBur();
    favourite_->setEnabled(bur != nullptr && bur->spec);
    favourite_->setChecked(bur != nullptr && grid_->isFavourite(*bur));
    if (bur == nullptr && grid_->shownBurs() == 0) return facts_->setText(tr("No bur is like this"));
    if (bur == nullptr) return facts_->setText(grid_->allowedBurs() == 0 ? translated(msg::kBurNotAllowed) : QString());
    facts_->setText(grid_->currentItem()->toolTip().replace('\n', ", "));
}

/// From the search the arrow keys go into the grid, and Enter takes what is current there.
bool BurDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched != search_ || event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        grid_->takeCurrent();
        return true;
    }
    if (key != Qt::Key_Down && key != Qt::Key_Up) return QDialog::eventFilter(watched, event);
    grid_->setFocus();
    return true;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/event_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

QTableWidgetItem* cell(const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
    return item;
}

}  // namespace

EventPanel::EventPanel(QWidget* parent) : QWidget(parent), lines_(new QTableWidget(0, 3)) {
    lines_->setObjectName("events");
    lines_->setAccessibleName(tr("What happened"));
    lines_->setHorizontalHeaderLabels({tr("Time, s"), tr("What"), tr("Where, mm")});
    lines_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    lines_->horizontalHeader()->setStretchLastSection(true);
    lines_->verticalHeader()->hide();
    lines_->setSelectionBehavior(QAbstractItemView::SelectRows);
    lines_->setSelectionMode(QAbstractItemView::SingleSelection);
    lines_->setTabKeyNavigation(false);
    lines_->setToolTip(tr("A double click shows the place in the middle of the picture"));
    connect(lines_, &QTableWidget::itemActivated, this,
            [this](const QTableWidgetItem* item) { emit placeChosen(places_[static_cast<std::size_t>(item->row())]); });
    auto* write = new QToolButton;
    write->setText(tr("Export…"));
    write->setToolTip(tr("Writes the list as a table (CSV)"));
    write->setObjectName("exportEvents");
    write->setEnabled(false);
    connect(write, &QToolButton::clicked, this, &EventPanel::exportRequested);
    write_ = write;
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2, 2, 2, 2);
    row->addWidget(lines_, 1);
    row->addWidget(write, 0, Qt::AlignTop);
}

void EventPanel::addLine(const CutEvent& event) {
    const QString time = locale().toString(event.time, 'f', 1);
    const QString what = translated(cutEventText(event.kind));
    const auto number = [this](double mm) { return locale().toString(mm, 'f', 2); };
    const int row = lines_->rowCount();
    lines_->insertRow(row);
    lines_->setItem(row, 0, cell(time));
    lines_->setItem(row, 1, cell(what));
    lines_->setItem(
        row, 2,
        cell(QString("%1   %2   %3").arg(number(event.place.x()), number(event.place.y()), number(event.place.z()))));
    lines_->scrollToBottom();
    places_.push_back(event.place);
    isTakenBack_.push_back(false);
    emit added(event);
    if (event.kind != CutEventKind::FirstContact) emit notified(tr("At %1 s: %2").arg(time, what));
}

/// What was taken back stays in the list, struck out.
void EventPanel::mark(std::size_t line, bool isTakenBack) {
    if (isTakenBack_[line] == isTakenBack) return;
    isTakenBack_[line] = isTakenBack;
    for (int column = 0; column < lines_->columnCount(); ++column) {
        QTableWidgetItem& item = *lines_->item(static_cast<int>(line), column);
        QFont font = item.font();
        font.setStrikeOut(isTakenBack);
        item.setFont(font);
        item.setToolTip(isTakenBack ? tr("Taken back: it does not count") : QString());
    }
}

void EventPanel::show(std::span<const CutEvent> events) {
    if (events.size() < places_.size()) {
        lines_->setRowCount(0);
        places_.clear();
        isTakenBack_.clear();
    }
    for (const CutEvent& event : events.subspan(places_.size())) addLine(event);
    for (std::size_t i = 0; i < events.size(); ++i) mark(i, events[i].isTakenBack);
    write_->setEnabled(!places_.empty());
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/panels/history_panel.h"

#include <QListWidget>
#include <QVBoxLayout>

#include "app/gui/text/translation.h"

namespace tactooth {

HistoryPanel::HistoryPanel(QWidget* parent) : QWidget(parent), lines_(new QListWidget) {
    lines_->setObjectName("history");
    lines_->setAccessibleName(tr("History"));
    lines_->setToolTip(tr("A click goes to that state; what comes after it can be redone until you do something else"));
    const auto choose = [this](const QListWidgetItem* line) {
        emit chosen(static_cast<std::size_t>(lines_->row(line)));
    };
    connect(lines_, &QListWidget::itemClicked, this, choose);
    connect(lines_, &QListWidget::itemActivated, this, choose);  // the Enter key
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(2, 2, 2, 2);
    column->addWidget(lines_);
}

void HistoryPanel::show(const WorkHistory& history) {
    if (shown_ == history.revision()) return;
    shown_ = history.revision();
    const QSignalBlocker blocked(lines_);
    lines_->clear();
    lines_->addItem(tr("The tooth as it was opened"));
    for (const WorkStep& step : history.steps()) {
        const int seconds = static_cast<int>(step.time);
        const QString time = QString("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
        lines_->addItem(tr("%1  %2").arg(time, translated(step.name)));
    }
    const int now = static_cast<int>(history.position());
    for (int row = 0; row < lines_->count(); ++row) {
        QListWidgetItem& line = *lines_->item(row);
        QFont font = line.font();
        font.setBold(row == now);
        line.setFont(font);
        if (row > now) line.setForeground(palette().color(QPalette::Disabled, QPalette::Text));
    }
    lines_->setCurrentRow(now);
    lines_->scrollToItem(lines_->item(now));
}

}  // namespace tactooth

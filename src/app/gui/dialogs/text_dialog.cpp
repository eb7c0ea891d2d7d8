// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/text_dialog.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

namespace tactooth {

TextDialog::TextDialog(const QString& title, const QString& html, QWidget* parent) : QDialog(parent) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* page = new QTextBrowser;
    page->setHtml(html);
    page->setAccessibleName(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(page, 1);
    column->addWidget(buttons);
    constexpr double kShare = 0.9;  // of the screen at most
    const QSize screen = kShare * parent->screen()->availableSize();
    const QMargins around = column->contentsMargins();
    page->document()->setTextWidth(-1);  // without line breaks
    const double wanted = page->document()->idealWidth();
    const int width = static_cast<int>(wanted) + page->verticalScrollBar()->sizeHint().width() + around.left() +
                      around.right() + 2 * page->frameWidth();
    page->document()->setTextWidth(std::min<double>(wanted, screen.width()));
    const int height = static_cast<int>(page->document()->size().height()) + buttons->sizeHint().height() +
                       column->spacing() + around.top() + around.bottom() + 2 * page->frameWidth() + 2;
    resize(QSize(width, height).boundedTo(screen));
    page->setFocus();  // arrow keys scroll
}

QString TextDialog::text() const { return findChild<QTextBrowser*>()->toHtml(); }

}  // namespace tactooth

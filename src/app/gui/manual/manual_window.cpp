// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/manual/manual_window.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/icons/line_icon.h"

namespace tactooth {
namespace {

constexpr int kPageRole = Qt::UserRole;
constexpr int kSectionRole = Qt::UserRole + 1;
constexpr std::size_t kMostHits = 100;  // more would not be read

QToolButton* button(const char* icon, const QString& text, const QKeySequence& key) {
    auto* result = new QToolButton;
    result->setObjectName(icon);
    result->setIcon(lineIcon(icon));
    result->setText(text);
    result->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    result->setShortcut(key);
    result->setToolTip(key.isEmpty() ? text : text + " (" + key.toString(QKeySequence::NativeText) + ")");
    result->setEnabled(false);
    return result;
}

}  // namespace

ManualWindow::ManualWindow(ManualPages pages, const QWidget& besides)
    : QDialog(nullptr, Qt::Window),
      pages_(std::move(pages)),
      browser_(new ManualBrowser(pages_)),
      contents_(new QTreeWidget),
      hits_(new QListWidget),
      side_(new QStackedWidget),
      wanted_(new QLineEdit),
      line_(new QLabel) {
    setObjectName("manual");
    setWindowTitle(tr("Manual of Tactooth"));
    setAttribute(Qt::WA_QuitOnClose, false);  // the program ends with its own window
    auto* column = new QVBoxLayout(this);
    addBar(*column);
    auto* parts = new QSplitter;
    parts->addWidget(makeSide());
    parts->addWidget(browser_);
    parts->setStretchFactor(1, 1);
    parts->setChildrenCollapsible(false);
    column->addWidget(parts, 1);
    line_->setObjectName("manualLine");
    line_->setWordWrap(true);
    line_->hide();
    column->addWidget(line_);
    connect(browser_, &ManualBrowser::opened, this, &ManualWindow::showPage);
    connect(browser_, &ManualBrowser::missed, this, [this](const QString& sentence) {
        line_->setText(sentence);
        line_->show();
    });
    fillContents();
    constexpr double kShare = 0.9;  // of the screen at most
    const int height = fontMetrics().height();
    const int wide = 62 * height, side = 16 * height;
    resize(QSize(wide, 46 * height).boundedTo(kShare * besides.screen()->availableSize()));
    parts->setSizes({side, width() - side});
}

void ManualWindow::addBar(QVBoxLayout& column) {
    auto* row = new QHBoxLayout;
    column.addLayout(row);
    QToolButton* const back = button("back", tr("Back"), QKeySequence("Alt+Left"));
    QToolButton* const forward = button("forward", tr("Forward"), QKeySequence("Alt+Right"));
    row->addWidget(back);
    row->addWidget(forward);
    row->addStretch();
    wanted_->setObjectName("manualSearch");
    wanted_->setPlaceholderText(tr("Search all pages (Ctrl+F)"));
    wanted_->setAccessibleName(tr("Search all pages"));
    wanted_->setClearButtonEnabled(true);
    wanted_->setMinimumWidth(18 * fontMetrics().height());
    row->addWidget(wanted_);
    connect(back, &QToolButton::clicked, browser_, &ManualBrowser::backward);
    connect(forward, &QToolButton::clicked, browser_, &ManualBrowser::forward);
    connect(browser_, &ManualBrowser::backwardAvailable, back, &QToolButton::setEnabled);
    connect(browser_, &ManualBrowser::forwardAvailable, forward, &QToolButton::setEnabled);
    connect(wanted_, &QLineEdit::textChanged, this, &ManualWindow::showHits);
    connect(wanted_, &QLineEdit::returnPressed, this, [this] {
        hits_->setCurrentRow(0);
        hits_->setFocus();
    });
    connect(new QShortcut(QKeySequence("Ctrl+F"), this), &QShortcut::activated, this, [this] {
        wanted_->setFocus();
        wanted_->selectAll();
    });
}

QWidget* ManualWindow::makeSide() {
    contents_->setObjectName("manualContents");
    contents_->setAccessibleName(tr("Contents"));
    contents_->setHeaderHidden(true);
    contents_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    contents_->header()->setStretchLastSection(false);
    hits_->setObjectName("manualHits");
    hits_->setAccessibleName(tr("Places found"));
    hits_->setWordWrap(true);
    hits_->setAlternatingRowColors(true);
    side_->addWidget(contents_);
    side_->addWidget(hits_);
    connect(contents_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* now) {
        if (now != nullptr) goToContents(*now);
    });
    connect(hits_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* now) {
        if (now == nullptr || !now->data(kPageRole).isValid()) return;
        browser_->open(now->data(kPageRole).toString(), now->data(kSectionRole).toInt());
    });
    return side_;
}

void ManualWindow::fillContents() {
    for (const QString& page : pages_.names()) {
        auto* item = new QTreeWidgetItem(contents_, {pages_.title(page)});
        item->setData(0, kPageRole, page);
        int section = 0;
        for (const QString& title : pages_.sections(page)) {
            auto* part = new QTreeWidgetItem(item, {title});
            part->setData(0, kPageRole, page);
            part->setData(0, kSectionRole, ++section);
        }
    }
}

void ManualWindow::goToContents(const QTreeWidgetItem& item) {
    browser_->open(item.data(0, kPageRole).toString(), item.data(0, kSectionRole).toInt());
}

void ManualWindow::open(const QString& page, int section) {
    wanted_->clear();
    if (isMinimized()) showNormal();
    show();
    browser_->open(page, section);  // now its size is known, and so is the place of each heading
    raise();
    activateWindow();
    browser_->setFocus();  // arrow keys scroll
}

/// Marks the page in the contents; one of its sections may be marked already.
void ManualWindow::showPage(const QString& page) {
    line_->hide();
    const QTreeWidgetItem* const now = contents_->currentItem();
    if (now != nullptr && now->data(0, kPageRole).toString() == page) return;
    const QSignalBlocker quiet(contents_);
    for (int i = 0; i < contents_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* const item = contents_->topLevelItem(i);
        const bool isIt = item->data(0, kPageRole).toString() == page;
        item->setExpanded(isIt);
        if (isIt) contents_->setCurrentItem(item);
    }
}

void ManualWindow::showHits() {
    const QString wanted = wanted_->text().simplified();
    browser_->mark(wanted);
    hits_->clear();
    side_->setCurrentWidget(wanted.isEmpty() ? static_cast<QWidget*>(contents_) : hits_);
    if (wanted.isEmpty()) return;
    for (const ManualPages::Hit& hit : pages_.search(wanted, kMostHits)) {
        const QStringList sections = pages_.sections(hit.page);
        QString place = pages_.title(hit.page);
        if (hit.section > 0 && hit.section <= sections.size()) place += " – " + sections[hit.section - 1];
        auto* item = new QListWidgetItem(place + "\n" + hit.text, hits_);
        item->setData(kPageRole, hit.page);
        item->setData(kSectionRole, hit.section);
    }
    if (hits_->count() == 0) {
        auto* nothing = new QListWidgetItem(tr("No page has these words."), hits_);
        nothing->setFlags(Qt::NoItemFlags);
    }
}

}  // namespace tactooth

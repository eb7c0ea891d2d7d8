// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/manual/manual_browser.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QEvent>
#include <QImage>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>

#include "app/gui/manual/messages.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr const char* kRoot = "/manual/";
constexpr const char* kSection = "section:";  // an anchor that is the number of a heading

QUrl addressOf(const QString& page) { return QUrl("qrc:" + QString(kRoot) + page); }

/// A page has one name in all languages.
QString pageOf(const QUrl& address) {
    const QString path = address.path().replace(".ja.md", ".md");
    return path.startsWith(kRoot) ? path.mid(QString(kRoot).size()) : path;
}

}  // namespace

ManualBrowser::ManualBrowser(const ManualPages& pages, QWidget* parent) : QTextBrowser(parent), pages_(pages) {
    setObjectName("manualPage");
    setOpenLinks(false);
    connect(this, &QTextBrowser::anchorClicked, this, &ManualBrowser::follow);
    connect(this, &QTextBrowser::sourceChanged, this, &ManualBrowser::finish);
    document()->setDocumentMargin(14);  // pixels: text that does not stick to the frame reads more easily
}

QString ManualBrowser::page() const { return pageOf(source()); }

void ManualBrowser::open(const QString& page, int section) {
    QUrl address = addressOf(page);
    if (section > 0) address.setFragment(kSection + QString::number(section));
    if (page == this->page()) reload();  // the keys may have changed
    setSource(address, QTextDocument::MarkdownResource);
}

/// Pages outside of the manual belong to the source; addresses of the web to the desktop.
void ManualBrowser::follow(const QUrl& link) {
    const QUrl address = source().resolved(link);
    if (address.scheme() != "qrc") {
        QDesktopServices::openUrl(address);
    } else if (pages_.has(pageOf(address))) {
        setSource(address, QTextDocument::MarkdownResource);
    } else {
        emit missed(translated(Message(msg::kManualNoPage, pageOf(address).toStdString())));
    }
}

QVariant ManualBrowser::loadResource(int type, const QUrl& name) {
    const QUrl address = source().resolved(name);
    if (type == QTextDocument::MarkdownResource) return pages_.text(pageOf(address));
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    constexpr int kWidest = 680;  // pixels of the desktop: as wide as the text beside it reads well
    const QImage whole(":" + address.path());
    const double scale = devicePixelRatioF();
    const int widest = static_cast<int>(kWidest * scale);
    QImage shown = whole.width() > widest ? whole.scaledToWidth(widest, Qt::SmoothTransformation) : whole;
    shown.setDevicePixelRatio(scale);
    return shown;
}

/// Also after Back and Forward, which then scroll to where the page was left.
void ManualBrowser::finish(const QUrl& shown) {
    drawTables();
    showMarks();
    goTo(shown.fragment());
    emit opened(pageOf(shown));  // source() may still be the page before
}

/// Markdown gives headings no names: the anchor is compared with that of each heading.
void ManualBrowser::goTo(const QString& anchor) {
    if (anchor.isEmpty()) return;
    (void)document()->size();  // lays out all of the page
    const QString wanted = QUrl::fromPercentEncoding(anchor.toUtf8());
    int section = 0;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level == 0) continue;
        if (level == 2) ++section;
        const bool isIt = wanted.startsWith(kSection) ? level == 2 && wanted == kSection + QString::number(section)
                                                      : anchorOf(block.text()) == wanted;
        if (!isIt) continue;
        const double top = document()->documentLayout()->blockBoundingRect(block).top();
        setTextCursor(QTextCursor(block));
        verticalScrollBar()->setValue(static_cast<int>(top));
        return;
    }
}

/// Thin lines and room around the words.
void ManualBrowser::drawTables() {
    for (QTextFrame* frame : document()->rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr) continue;
        QTextTableFormat format = table->format();
        format.setCellPadding(4);
        format.setCellSpacing(0);
        format.setBorder(1);
        format.setBorderCollapse(true);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(palette().color(QPalette::Mid));
        format.setTopMargin(6);
        format.setBottomMargin(10);
        table->setFormat(format);
    }
}

void ManualBrowser::mark(const QString& words) {
    marked_ = words.simplified().split(' ', Qt::SkipEmptyParts);
    showMarks();
}

void ManualBrowser::showMarks() {
    constexpr qsizetype kMost = 300;  // more would only cost time
    QList<ExtraSelection> marks;
    QTextCharFormat format;
    format.setBackground(palette().color(QPalette::Highlight));
    format.setForeground(palette().color(QPalette::HighlightedText));
    for (const QString& word : marked_) {
        for (QTextCursor found = document()->find(word); !found.isNull() && marks.size() < kMost;
             found = document()->find(word, found)) {
            marks.append({found, format});
        }
    }
    setExtraSelections(marks);
}

void ManualBrowser::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || source().isEmpty()) return;
    drawTables();
    showMarks();
}

}  // namespace tactooth

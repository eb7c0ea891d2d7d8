// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/card_list.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>

#include "app/gui/dialogs/cell_painting.h"
#include "app/gui/icons/line_icon.h"

namespace tactooth {
namespace {

constexpr int kCardRole = Qt::UserRole;  // number of the card; none: a heading
constexpr int kFactsRole = kCardRole + 1;
constexpr int kPictureRole = kCardRole + 2;
constexpr int kIconRole = kCardRole + 3;

bool isCard(const QListWidgetItem* item) { return item != nullptr && item->data(kCardRole).isValid(); }

}  // namespace

class CardList::Delegate final : public QStyledItemDelegate {
public:
    explicit Delegate(CardList& list) : QStyledItemDelegate(&list), list_(list) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        if (index.data(kCardRole).isValid()) {
            paintCard(*painter, option, index);
        } else {
            paintHeading(*painter, option, index.data().toString());
        }
        painter->restore();
    }

private:
    void paintCard(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
        const QPalette& colours = option.palette;
        const bool isCurrent = (option.state & QStyle::State_Selected) != 0 && list_.hasFocus();
        paintCellGround(painter, option, isCurrent);
        const QRect picture(option.rect.topLeft() + QPoint(kCellPad, kCellPad), list_.pictureSize());
        paintPicture(painter, picture, index, colours);
        const int line = option.fontMetrics.height();
        QRect words(picture.left(), picture.bottom() + 3, picture.width(), 2 * line);
        painter.setPen(colours.color(QPalette::Active, QPalette::Text));
        painter.drawText(words, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, index.data().toString());
        QColor faint = colours.color(QPalette::Active, QPalette::Text);
        faint.setAlphaF(0.65F);
        painter.setPen(faint);
        words.moveTop(words.bottom() + 1);
        painter.drawText(
            words, Qt::AlignLeft | Qt::AlignTop,
            option.fontMetrics.elidedText(index.data(kFactsRole).toString(), Qt::ElideRight, words.width()));
    }

    /// The middle of the picture, as large as the card lets it be.
    static void paintPicture(QPainter& painter, const QRect& place, const QModelIndex& index, const QPalette& colours) {
        QPainterPath rounded;
        rounded.addRoundedRect(place, kCellPad, kCellPad);
        const auto drawn = index.data(kPictureRole).value<QPixmap>();
        if (drawn.isNull()) {
            painter.fillPath(rounded, colours.color(QPalette::Active, QPalette::AlternateBase));
            const int side = place.height() / 2;
            const QRect middle(place.center() - QPoint(side / 2, side / 2), QSize(side, side));
            return lineIcon(index.data(kIconRole).toByteArray().constData()).paint(&painter, middle);
        }
        painter.save();
        painter.setClipPath(rounded);
        QRect shown(QPoint(), drawn.size().scaled(place.size(), Qt::KeepAspectRatioByExpanding));
        shown.moveCenter(place.center());
        painter.drawPixmap(shown, drawn);
        painter.restore();
    }

    CardList& list_;
};

CardList::CardList(const QString& name) {
    setAccessibleName(name);
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setSpacing(kCellSpacing);
    setMouseTracking(true);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setItemDelegate(new Delegate(*this));
}

QSize CardList::pictureSize() const {
    constexpr double kTall = 6;  // heights of the font
    const int height = static_cast<int>(kTall * fontMetrics().height());
    return {3 * height / 2, height};
}

QSize CardList::cardSize() const {
    return pictureSize() + QSize(2 * kCellPad, 2 * kCellPad + 5 + 3 * fontMetrics().height());
}

int CardList::heightOf(int rows) const { return rows * (cardSize().height() + 2 * kCellSpacing); }

int CardList::widthOf(int columns) const {
    return columns * (cardSize().width() + kCellSpacing) + 2 * kCellSpacing + verticalScrollBar()->sizeHint().width();
}

void CardList::addHeading(const QString& text) {
    auto* heading = new QListWidgetItem(text, this);
    heading->setFlags(Qt::NoItemFlags);
    widenHeadings();
}

int CardList::addCard(const Card& card) {
    auto* item = new QListWidgetItem(card.title, this);
    item->setData(kCardRole, cards_);
    item->setData(kFactsRole, card.facts);
    item->setData(kPictureRole, card.picture);
    item->setData(kIconRole, QByteArray(card.icon));
    item->setToolTip(card.tip);
    item->setData(Qt::AccessibleTextRole, QString("%1, %2").arg(card.title, card.facts));
    item->setSizeHint(cardSize());
    return cards_++;
}

QListWidgetItem* CardList::itemOf(int card) const {
    for (int i = 0; i < count(); ++i) {
        if (isCard(item(i)) && item(i)->data(kCardRole).toInt() == card) return item(i);
    }
    return nullptr;
}

void CardList::take(const QListWidgetItem* item) {
    if (isCard(item)) emit taken(item->data(kCardRole).toInt());
}

/// A heading is as wide as the list, so that it has a row of its own.
void CardList::widenHeadings() {
    const int height = static_cast<int>(1.4 * fontMetrics().height());
    for (int i = 0; i < count(); ++i) {
        if (!isCard(item(i))) item(i)->setSizeHint({viewport()->width() - 3 * kCellSpacing, height});
    }
}

void CardList::keyPressEvent(QKeyEvent* event) {
    const bool takes = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (takes && isCard(currentItem())) return take(currentItem());
    QListWidget::keyPressEvent(event);
}

void CardList::mouseReleaseEvent(QMouseEvent* event) {
    QListWidget::mouseReleaseEvent(event);
    if (event->button() == Qt::LeftButton) take(itemAt(event->pos()));
}

void CardList::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    widenHeadings();
}

/// Who comes by a key finds a card chosen.
void CardList::focusInEvent(QFocusEvent* event) {
    QListWidget::focusInEvent(event);
    if (isCard(currentItem()) || cards_ == 0) return;
    setCurrentItem(itemOf(0));
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialogs/bur_grid.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>
#include <utility>

#include "app/gui/dialogs/cell_painting.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"

namespace tactooth {
namespace {

constexpr int kPlaceRole = Qt::UserRole;  // in the list of the drill bar; none: a heading
constexpr int kFavouriteRole = kPlaceRole + 1;
constexpr int kExerciseRole = kPlaceRole + 2;
constexpr double kTall = 6.5;  // heights of the font: the picture of a bur
constexpr double kWide = 3.4;  // likewise, for a wheel of 4 mm and a number beside the star
const QString kStar = QStringLiteral("\u2605"), kEmptyStar = QStringLiteral("\u2606");

}  // namespace

/// Draws a heading, or a cell: picture, number, star, and the mark of the exercise.
class BurGrid::Delegate final : public QStyledItemDelegate {
public:
    explicit Delegate(BurGrid& grid) : QStyledItemDelegate(&grid), grid_(grid) {}

    /// The upper right corner of a cell.
    [[nodiscard]] static QRect starIn(const QRect& cell, const QFontMetrics& metrics) {
        const int side = metrics.height() + 4;
        return {cell.right() - side, cell.top() + 1, side, side};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        painter->save();
        if (index.data(kPlaceRole).isValid()) {
            paintBur(*painter, option, index);
        } else {
            paintGroup(*painter, option, index.data().toString());
        }
        painter->restore();
    }

private:
    static void paintGroup(QPainter& painter, const QStyleOptionViewItem& option, const QString& text) {
        paintHeading(painter, option, text);
        painter.setPen(option.palette.color(QPalette::Active, QPalette::Mid));
        painter.drawLine(option.rect.bottomLeft() + QPoint(kCellPad, 0),
                         option.rect.bottomRight() - QPoint(kCellPad, 0));
    }

    void paintBur(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
        painter.setRenderHint(QPainter::Antialiasing);
        constexpr double kPale = 0.3;
        if ((option.state & QStyle::State_Enabled) == 0) painter.setOpacity(kPale);
        const bool isCurrent = (option.state & QStyle::State_Selected) != 0;
        const QColor highlight = option.palette.color(QPalette::Active, QPalette::Highlight);
        const QColor text = option.palette.color(QPalette::Active, QPalette::Text);
        paintCellGround(painter, option, isCurrent);
        const QSize size = grid_.pictures_.size();
        const QRect picture(QPoint(option.rect.center().x() - size.width() / 2, option.rect.top() + kCellPad), size);
        const auto& bur = grid_.burs_[static_cast<std::size_t>(index.data(kPlaceRole).toInt())];
        const QPixmap* drawn = bur.spec ? grid_.pictures_.find(bur.spec->number) : nullptr;
        if (drawn != nullptr) painter.drawPixmap(picture.topLeft(), *drawn);
        if (!bur.spec) lineIcon("bur").paint(&painter, picture);
        painter.setPen(text);
        const QRect line = option.rect.adjusted(2, kCellPad + size.height(), -2, -2);
        painter.drawText(line, Qt::AlignCenter,
                         option.fontMetrics.elidedText(index.data().toString(), Qt::ElideMiddle, line.width()));
        const bool isFavourite = index.data(kFavouriteRole).toBool();
        if (bur.spec && (isFavourite || isCurrent || isUnderMouse(option))) {
            painter.drawText(starIn(option.rect, option.fontMetrics), Qt::AlignCenter,
                             isFavourite ? kStar : kEmptyStar);
        }
        if (index.data(kExerciseRole).toBool()) paintExercise(painter, option.rect, highlight);
    }

    /// A flag in the upper left corner.
    static void paintExercise(QPainter& painter, const QRect& cell, const QColor& colour) {
        const QPointF pole = cell.topLeft() + QPointF(8, 7);
        painter.setPen(QPen(colour, 2));
        painter.drawLine(pole, pole + QPointF(0, 16));
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawPolygon(QPolygonF{pole, pole + QPointF(11, 4.5), pole + QPointF(0, 9)});
    }

    BurGrid& grid_;
};

BurGrid::BurGrid(const std::vector<BurItem>& burs, std::set<std::string> favourites, std::set<std::string> exercise,
                 BurPictures& pictures)
    : burs_(burs), favourites_(std::move(favourites)), exercise_(std::move(exercise)), pictures_(pictures) {
    setObjectName("burGrid");
    setAccessibleName(tr("Burs"));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setSpacing(kCellSpacing);
    setMouseTracking(true);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    setItemDelegate(new Delegate(*this));
    const double letter = fontMetrics().height();
    pictures_.setSize(QSizeF(kWide * letter, kTall * letter).toSize(), devicePixelRatioF());
    for (const BurGroup& group : groupedByShape(burs_)) add(group);
    connect(&drawing_, &QTimer::timeout, this, &BurGrid::drawNext);
    drawing_.start(0);
}

void BurGrid::add(const BurGroup& group) {
    auto* heading = new QListWidgetItem(group.title, this);
    heading->setFlags(Qt::NoItemFlags);
    QSize cell = pictures_.size() + QSize(6 * kCellPad, 2 * kCellPad + fontMetrics().height());
    cell.setWidth(std::max(cell.width(), fontMetrics().horizontalAdvance("878K-016") + 2 * kCellPad));
    for (const BurItem& bur : group.burs) {
        auto* item = new QListWidgetItem(bur.spec ? QString::fromStdString(bur.spec->number) : bur.title, this);
        item->setData(kPlaceRole, bur.place);
        item->setData(kExerciseRole, bur.spec && exercise_.contains(bur.spec->number));
        item->setSizeHint(cell);
        if (!bur.isAllowed) item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
        describe(*item);
    }
}

void BurGrid::describe(QListWidgetItem& item) const {
    const BurItem& bur = *burOf(&item);
    item.setData(kFavouriteRole, isFavourite(bur));
    QStringList lines = QStringList(bur.title) + factsOf(bur);
    if (item.data(kExerciseRole).toBool()) lines << tr("Used in this exercise");
    if (isFavourite(bur)) lines << tr("Favourite");
    if (!bur.isAllowed) lines << translated(msg::kBurNotAllowed);
    item.setToolTip(lines.join('\n'));
    item.setData(Qt::AccessibleTextRole, lines.join(", "));
}

const BurItem* BurGrid::burOf(const QListWidgetItem* item) const {
    if (item == nullptr || !item->data(kPlaceRole).isValid()) return nullptr;
    return &burs_[static_cast<std::size_t>(item->data(kPlaceRole).toInt())];
}

const BurItem* BurGrid::currentBur() const {
    return currentItem() != nullptr && !currentItem()->isHidden() ? burOf(currentItem()) : nullptr;
}

bool BurGrid::isFavourite(const BurItem& bur) const { return bur.spec && favourites_.contains(bur.spec->number); }

/// A heading is as wide as the grid, so that it has a row of its own.
void BurGrid::widenHeadings() {
    const int height = static_cast<int>(1.6 * fontMetrics().height());
    for (int i = 0; i < count(); ++i) {
        if (burOf(item(i)) == nullptr) item(i)->setSizeHint({viewport()->width() - 3 * kCellSpacing, height});
    }
}

void BurGrid::resizeEvent(QResizeEvent* event) {
    QListWidget::resizeEvent(event);
    widenHeadings();
    if (currentItem() != nullptr) scrollToItem(currentItem());
}

/// Those in sight first.
void BurGrid::drawNext() {
    const QListWidgetItem* next = nullptr;
    for (int i = 0; i < count(); ++i) {
        const BurItem* bur = burOf(item(i));
        if (bur == nullptr || !bur->spec || pictures_.find(bur->spec->number) != nullptr) continue;
        const bool isInSight = viewport()->rect().intersects(visualItemRect(item(i))) && !item(i)->isHidden();
        if (next == nullptr || isInSight) next = item(i);
        if (isInSight) break;
    }
    if (next == nullptr) return drawing_.stop();
    pictures_.draw(*burOf(next)->spec);
    viewport()->update(visualItemRect(next));
}

void BurGrid::filter(const QString& search, bool favouritesOnly) {
    QListWidgetItem* heading = nullptr;
    bool hasAny = false;
    for (int i = 0; i < count(); ++i) {
        const BurItem* bur = burOf(item(i));
        if (bur == nullptr) {
            if (heading != nullptr) heading->setHidden(!hasAny);
            heading = item(i);
            hasAny = false;
            continue;
        }
        const bool isShown = matches(*bur, search) && (!favouritesOnly || isFavourite(*bur));
        item(i)->setHidden(!isShown);
        hasAny = hasAny || isShown;
    }
    if (heading != nullptr) heading->setHidden(!hasAny);
    for (int i = 0; i < count() && currentBur() == nullptr; ++i) {
        const BurItem* bur = burOf(item(i));
        if (bur != nullptr && bur->isAllowed && !item(i)->isHidden()) setCurrentItem(item(i));
    }
    doItemsLayout();
    emit currentItemChanged(currentItem(), nullptr);  // it may have been hidden
}

void BurGrid::select(int place) {
    for (int i = 0; i < count(); ++i) {
        if (burOf(item(i)) != nullptr && burOf(item(i))->place == place) setCurrentItem(item(i));
    }
}

int BurGrid::shownBurs() const {
    int shown = 0;
    for (int i = 0; i < count(); ++i) shown += burOf(item(i)) != nullptr && !item(i)->isHidden() ? 1 : 0;
    return shown;
}

int BurGrid::allowedBurs() const {
    int allowed = 0;
    for (int i = 0; i < count(); ++i) {
        const BurItem* bur = burOf(item(i));
        allowed += bur != nullptr && bur->isAllowed && !item(i)->isHidden() ? 1 : 0;
    }
    return allowed;
}

void BurGrid::takeCurrent() {
    const BurItem* bur = currentBur();
    if (bur != nullptr && bur->isAllowed) emit taken(bur->place);
}

void BurGrid::toggleFavourite() {
    const BurItem* bur = currentBur();
    if (bur == nullptr || !bur->spec) return;
    if (favourites_.erase(bur->spec->number) == 0) favourites_.insert(bur->spec->number);
    describe(*currentItem());
    emit favouritesChanged(favourites_);
}

QRect BurGrid::starOf(const QListWidgetItem& item) const {
    return Delegate::starIn(visualItemRect(&item), fontMetrics());
}

void BurGrid::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return takeCurrent();
    if (event->key() == Qt::Key_Space) return toggleFavourite();
    const QString typed = event->text();
    if (!typed.isEmpty() && typed[0].isPrint()) return emit lettersTyped(typed);
    QListWidget::keyPressEvent(event);
}

void BurGrid::mouseReleaseEvent(QMouseEvent* event) {
    QListWidget::mouseReleaseEvent(event);
    const QPoint place = event->position().toPoint();
    const QListWidgetItem* under = itemAt(place);
    if (event->button() != Qt::LeftButton || under == nullptr || under != currentItem()) return;
    if (burOf(under) == nullptr) return;
    if (starOf(*under).contains(place)) return toggleFavourite();
    takeCurrent();
}

}  // namespace tactooth

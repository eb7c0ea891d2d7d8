// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/pdf_pages.h"

#include <QSvgRenderer>
#include <algorithm>

namespace tactooth {
namespace {

constexpr double kPerMm = PageTarget::kResolution / 25.4;  // dots
constexpr double kCellGap = 2;                             // mm between two columns
constexpr double kBarHeight = 2;                           // mm
constexpr double kFooterAt = 264;                          // mm
constexpr double kTextMiddle = 1.9;                        // mm: of a line of a table's text below its top
const QColor kLine(214, 221, 227), kEmptyBar(227, 232, 236);

/// Of the bar below the top of its row: below a text of this height, or beside the texts of the other columns.
double barTop(const PdfPages::Row& row, double textHeight) {
    return row.cells.value(row.barColumn).isEmpty() ? kTextMiddle - kBarHeight / 2 : textHeight + 0.5;
}

}  // namespace

PdfPages::PdfPages(PageTarget& target, const QString& footer, const QString& family)
    : target_(target), footer_(footer), family_(family) {
    target_.beginPage(painter_);
    drawFooter();
}

QRectF PdfPages::dots(const QRectF& box) const {
    return {box.x() * kPerMm, box.y() * kPerMm, box.width() * kPerMm, box.height() * kPerMm};
}

void PdfPages::use(const Font& font) {
    QFont shown(family_);
    shown.setStyleHint(QFont::SansSerif);
    shown.setPointSizeF(font.points);
    shown.setBold(font.isBold);
    painter_.setFont(shown);
    painter_.setPen(font.colour);
}

double PdfPages::heightOf(const QString& text, const Font& font, double width) {
    use(font);
    return painter_.boundingRect(dots({0, 0, width, kHeight}), Qt::TextWordWrap, text).height() / kPerMm;
}

void PdfPages::drawFooter() {
    const Font font{7.5, false, kFaint};
    text({0, kFooterAt, kWidth - 20, 5}, footer_, font, Qt::AlignLeft | Qt::AlignTop);
    text({kWidth - 20, kFooterAt, 20, 5}, QString::number(page_), font, Qt::AlignRight | Qt::AlignTop);
}

void PdfPages::beginPage() {
    target_.beginPage(painter_);
    ++page_;
    y_ = 0;
    drawFooter();
}

void PdfPages::makeRoom(double height) {
    if (y_ > 0 && y_ + height > kHeight) beginPage();
}

void PdfPages::text(const QRectF& box, const QString& text, const Font& font, Qt::Alignment align) {
    use(font);
    painter_.drawText(dots(box), static_cast<int>(align) | Qt::TextWordWrap, text);
}

void PdfPages::frame(const QRectF& box, const QColor& colour) {
    painter_.setPen(QPen(colour, 0.5 * kPerMm));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRoundedRect(dots(box), 2 * kPerMm, 2 * kPerMm);
}

void PdfPages::paragraph(const QString& text, const Font& font, double width) {
    const double height = heightOf(text, font, width);
    makeRoom(height);
    this->text({0, y_, width, height + 1}, text, font, Qt::AlignLeft | Qt::AlignTop);
    y_ += height;
}

void PdfPages::heading(const QString& text, double following) {
    constexpr double kAbove = 4, kHeadingHeight = 6;
    const Font font{11.5, true, kInk};
    makeRoom(kAbove + kHeadingHeight + following);
    if (y_ > 0) y_ += kAbove;
    this->text({0, y_, kWidth, kHeadingHeight}, text, font, Qt::AlignLeft | Qt::AlignTop);
    y_ += kHeadingHeight;
    painter_.fillRect(dots({0, y_, kWidth, 0.3}), kLine);
    y_ += 1;
}

double PdfPages::heightOf(const std::vector<Column>& columns, const Row& row) {
    double height = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double width = columns[i].width - kCellGap;
        double cell = heightOf(row.cells.value(static_cast<int>(i)), row.font, width);
        if (static_cast<int>(i) == row.barColumn) cell = barTop(row, cell) + kBarHeight;
        height = std::max(height, cell);
    }
    return height + 2 * row.gap;
}

void PdfPages::row(const std::vector<Column>& columns, const Row& row) {
    const double height = heightOf(columns, row);
    makeRoom(height);
    double x = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double width = columns[i].width - kCellGap;
        text({x, y_ + row.gap, width, height}, row.cells.value(static_cast<int>(i)), row.font,
             columns[i].align | Qt::AlignTop);
        if (static_cast<int>(i) == row.barColumn) {
            const double top = barTop(row, heightOf(row.cells.value(row.barColumn), row.font, width));
            const QRectF bar(x, y_ + row.gap + top, width, kBarHeight);
            painter_.fillRect(dots(bar), kEmptyBar);
            painter_.fillRect(dots({bar.x(), bar.y(), std::max(0.02, row.share) * width, bar.height()}), row.barColour);
        }
        x += columns[i].width;
    }
    y_ += height;
    painter_.fillRect(dots({0, y_, kWidth, 0.15}), kLine);
}

void PdfPages::drawings(const std::vector<Drawing>& drawings) {
    constexpr double kGap = 6, kTitle = 5;
    double height = 0, x = 0;
    for (const Drawing& each : drawings) height = std::max(height, each.height + (each.title.isEmpty() ? 0 : kTitle));
    makeRoom(height);
    for (const Drawing& each : drawings) {
        QSvgRenderer renderer(QByteArray::fromStdString(each.svg));
        renderer.render(&painter_, dots({x, y_, each.width, each.height}));
        text({x, y_ + each.height + 0.5, each.width, kTitle}, each.title, {8, false, kFaint},
             Qt::AlignLeft | Qt::AlignTop);
        x += each.width + kGap;
    }
    y_ += height;
}

void PdfPages::pictures(const std::vector<std::pair<QString, QImage>>& pictures, double width, std::size_t perRow) {
    constexpr double kGap = 3, kTitle = 5;
    for (std::size_t first = 0; first < pictures.size(); first += perRow) {
        const std::size_t end = std::min(pictures.size(), first + perRow);
        double height = 0;
        for (std::size_t i = first; i < end; ++i) {
            const QImage& picture = pictures[i].second;
            height = std::max(height, width * picture.height() / std::max(1, picture.width()));
        }
        makeRoom(height + kTitle);
        for (std::size_t i = first; i < end; ++i) {
            const QImage& picture = pictures[i].second;
            const double x = static_cast<double>(i - first) * (width + kGap);
            const double own = width * picture.height() / std::max(1, picture.width());
            painter_.drawImage(dots({x, y_, width, own}), picture);
            text({x, y_ + own + 0.5, width, kTitle}, pictures[i].first, {8, false, kFaint},
                 Qt::AlignLeft | Qt::AlignTop);
        }
        y_ += height + kTitle;
    }
}

}  // namespace tactooth

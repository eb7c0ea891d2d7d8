// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/report_pages_view.h"

#include <QPainter>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tactooth {
namespace {

constexpr int kGap = 10;                        // pixels around a page
constexpr double kHeightToWidth = 297.0 / 210;  // A4
constexpr double kSmallest = 0.5, kLargest = 4;
constexpr int kSettledMs = 60;  // a window that is being dragged has another size all the time

}  // namespace

/// Shows the pages, stretched until they are drawn in their new size.
class ReportPagesView::Paper final : public QWidget {
public:
    explicit Paper(const std::vector<QImage>& pages) : pages_(pages) {}

    /// `width`: of a page, in pixels of Qt.
    void layOut(int width) {
        width_ = width;
        const auto pages = static_cast<int>(pages_.size());
        setFixedSize(width + 2 * kGap, pages * (pageHeight() + kGap) + kGap);
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        int y = kGap;
        for (const QImage& page : pages_) {
            painter.drawImage(QRect(kGap, y, width_, pageHeight()), page);
            y += pageHeight() + kGap;
        }
    }

private:
    [[nodiscard]] int pageHeight() const { return static_cast<int>(std::lround(width_ * kHeightToWidth)); }

    const std::vector<QImage>& pages_;
    int width_ = 0;
};

ReportPagesView::ReportPagesView(Source source, QWidget* parent)
    : QScrollArea(parent), source_(std::move(source)), paper_(new Paper(pages_)) {
    setObjectName("reportPages");
    setAccessibleName(tr("Pages of the report"));
    setBackgroundRole(QPalette::Mid);
    setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // else the width of the pages would depend on itself
    setWidget(paper_);
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &ReportPagesView::draw);
}

void ReportPagesView::draw() {
    const int width = std::max(1, static_cast<int>(std::lround(zoom_ * (viewport()->width() - 2 * kGap))));
    const int pixels = static_cast<int>(std::lround(width * devicePixelRatioF()));
    if (pixels != std::exchange(drawnWidth_, pixels)) pages_ = source_(pixels);
    paper_->layOut(width);
}

void ReportPagesView::setZoom(double zoom) {
    zoom = std::clamp(zoom, kSmallest, kLargest);
    if (zoom == std::exchange(zoom_, zoom)) return;
    const QScrollBar& bar = *verticalScrollBar();
    const double place = bar.maximum() > 0 ? static_cast<double>(bar.value()) / bar.maximum() : 0;
    draw();
    verticalScrollBar()->setValue(static_cast<int>(place * verticalScrollBar()->maximum()));
}

void ReportPagesView::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    if (pages_.empty()) return draw();
    later_.start(kSettledMs);
}

void ReportPagesView::wheelEvent(QWheelEvent* event) {
    if (!(event->modifiers() & Qt::ControlModifier)) return QScrollArea::wheelEvent(event);
    event->angleDelta().y() > 0 ? zoomIn() : zoomOut();
    event->accept();
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/report_pages.h"

#include <cmath>

#include "app/common/report/pdf_pages.h"
#include "app/common/report/report_pdf.h"

namespace tactooth {
namespace {

constexpr double kPaperWidth = 210, kPaperHeight = 297;  // mm: A4
constexpr double kInch = 25.4;                           // mm

/// The pages are laid out in the dots of the file and drawn smaller, so that the lines break where they do on paper.
class ImageTarget final : public PageTarget {
public:
    explicit ImageTarget(int width)
        : size_(width, static_cast<int>(std::lround(width * kPaperHeight / kPaperWidth))),
          scale_(width / (kPaperWidth / kInch * kResolution)) {}

    void beginPage(QPainter& painter) override {
        if (painter.isActive()) painter.end();
        QImage page(size_, QImage::Format_RGB32);
        page.fill(Qt::white);
        constexpr int kDotsPerMetre = static_cast<int>(kResolution / kInch * 1000);
        page.setDotsPerMeterX(kDotsPerMetre);
        page.setDotsPerMeterY(kDotsPerMetre);
        pages_.push_back(std::move(page));
        painter.begin(&pages_.back());
        painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
        painter.scale(scale_, scale_);
        constexpr double kMarginDots = kMargin / kInch * kResolution;
        painter.translate(kMarginDots, kMarginDots);
    }
    [[nodiscard]] std::vector<QImage> take() { return std::move(pages_); }

private:
    QSize size_;
    double scale_;
    std::vector<QImage> pages_;
};

}  // namespace

std::vector<QImage> reportPages(const AssessmentReport& report, int width) {
    ImageTarget target(width);
    drawReport(target, report);
    return target.take();
}

}  // namespace tactooth

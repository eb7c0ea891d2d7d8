// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_pdf.h"

#include <QBuffer>
#include <QByteArray>

#include "app/cli/cases/pdf_pages.h"
#include "app/common/offscreen_application.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

constexpr double kPictureWidth = 58;  // mm: three side by side
constexpr int kResolution = 600;      // dots per inch
const QColor kPassed(23, 96, 58), kFailed(156, 43, 26);

QString shown(std::string_view text) { return QString::fromStdString(displayText(std::string(text))); }

QString factsOf(const AssessmentReport& report) {
    QStringList lines;
    for (const ReportFact& fact : reportFacts(report)) lines << shown(fact.title) + ": " + shown(fact.value);
    return lines.join('\n');
}

void drawHead(PdfPages& pages, const AssessmentReport& report) {
    constexpr double kMarkWidth = 38, kMarkHeight = 26;
    const Mark& mark = report.mark;
    const QColor colour = mark.passes ? kPassed : kFailed;
    const QRectF box(PdfPages::kWidth - kMarkWidth, 0, kMarkWidth, kMarkHeight);
    pages.frame(box, colour);
    const QString number = mark.value ? QString::number(*mark.value, 'f', 1) : QStringLiteral("–");
    pages.text(box.adjusted(0, 1, 0, 0), number, {26, true, colour}, Qt::AlignHCenter | Qt::AlignTop);
    pages.text(box.adjusted(0, 14, 0, 0), "of 100\n" + shown(resultText(report)), {9, false, colour},
               Qt::AlignHCenter | Qt::AlignTop);
    pages.paragraph("Assessment of a preparation", {17, true}, box.x() - 5);
    pages.skip(1);
    pages.paragraph(factsOf(report), {9.5}, box.x() - 5);
    if (pages.y() < kMarkHeight) pages.skip(kMarkHeight - pages.y());
}

QStringList cellsOf(const AssessmentReport& report, const CriterionScore& each) {
    const Criterion& criterion = *each.criterion;
    QStringList cells;
    cells << shown(criterion.title) + (criterion.critical ? " (critical)" : "");
    cells << (each.measured.value ? shown(valueText(*criterion.metric, *each.measured.value))
                                  : "not measurable: " + shown(each.measured.reason->english));
    cells << (each.score ? QString::number(*each.score, 'f', 0) : QStringLiteral("–"));
    cells << (each.level ? shown(levelText(*each.level).english) : QString());
    cells << (criterion.weight > 0 ? QString::number(criterion.weight) : QStringLiteral("limit"));
    cells << (each.lost > 0 ? QStringLiteral("−") + QString::number(each.lost, 'f', 1) : QString());
    cells << shown(placeAndMomentText(report, each.measured));
    return cells;
}

void drawCriteria(PdfPages& pages, const AssessmentReport& report) {
    constexpr int kLevelColumn = 3;
    const std::vector<PdfPages::Column> columns = {
        {50}, {28, Qt::AlignRight}, {14, Qt::AlignRight}, {26}, {15, Qt::AlignRight}, {14, Qt::AlignRight}, {35}};
    pages.heading("What the mark is made of", 20);
    pages.row(columns, {{"Criterion", "Measured", "Score", "Level", "Weight", "Lost", "Where, when"},
                        {8, true, PdfPages::kFaint}});
    for (const CriterionScore& each : report.mark.criteria) {
        PdfPages::Row row{cellsOf(report, each), {8.5}};
        if (each.score && each.level) {
            row.barColumn = kLevelColumn;
            row.share = *each.score / 100;
            row.barColour = QColor(shown(levelColour(*each.level)));
        }
        pages.row(columns, row);
    }
    pages.skip(1.5);
    pages.paragraph(shown(weightedMeanText(report.mark)), {9});
    for (const Criterion* each : report.mark.limitedBy) {
        pages.paragraph("The mark is limited by: " + shown(each->title), {9, true});
    }
}

void drawPictures(PdfPages& pages, const AssessmentReport& report) {
    constexpr double kPictureHeight = 50;  // mm, with its title
    pages.heading("Distance to the ideal preparation", kPictureHeight);
    if (report.pictures.empty()) return pages.paragraph(shown(report.noPictures), {9, false, PdfPages::kFaint});
    std::vector<std::pair<QString, QImage>> pictures;
    for (const ReportPicture& each : report.pictures) {
        const QByteArray png = QByteArray::fromBase64(QByteArray::fromStdString(each.pngBase64));
        pictures.emplace_back(shown(each.title), QImage::fromData(png, "PNG"));
    }
    pages.skip(1);
    pages.pictures(pictures, kPictureWidth);
}

/// The definitions are left out: docs/assessment.md has them, and the page in HTML.
void drawMetrics(PdfPages& pages, const AssessmentReport& report) {
    const std::vector<PdfPages::Column> columns = {{80}, {62, Qt::AlignRight}, {40}};
    pages.heading("All measures", 20);
    pages.row(columns, {{"Measure", "Value", "Where, when"}, {7.5, true, PdfPages::kFaint}});
    for (const auto& [metric, measured] : report.metrics) {
        const QString value =
            measured.value ? shown(valueText(*metric, *measured.value)) : shown(measured.reason->english);
        pages.row(columns, {{shown(metric->title), value, shown(placeAndMomentText(report, measured))},
                            {7.5, false, measured.value ? PdfPages::kInk : PdfPages::kFaint}});
    }
}

}  // namespace

std::string reportPdf(const AssessmentReport& report) {
    const OffscreenApplication application;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(kResolution);
        writer.setPageSize(QPageSize(QPageSize::A4));
        constexpr double kMargin = 14;  // mm
        writer.setPageMargins(QMarginsF(kMargin, kMargin, kMargin, kMargin), QPageLayout::Millimeter);
        writer.setTitle("Assessment: " + shown(report.student));
        writer.setCreator(shown(report.program));
        PdfPages pages(writer, shown(footerText(report)));
        drawHead(pages, report);
        drawCriteria(pages, report);
        drawPictures(pages, report);
        pages.beginPage();
        drawMetrics(pages, report);
    }
    return bytes.toStdString();
}

}  // namespace tactooth

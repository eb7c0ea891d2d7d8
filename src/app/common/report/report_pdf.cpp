// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/report_pdf.h"

#include <QBuffer>
#include <QByteArray>
#include <QPdfWriter>
#include <algorithm>
#include <array>

#include "app/common/offscreen_application.h"
#include "app/common/report/pdf_pages.h"
#include "app/common/report/report_font.h"
#include "assessment/report/messages.h"
#include "assessment/report/next_steps.h"
#include "assessment/report/strip_svg.h"
#include "assessment/report/trend_svg.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

constexpr double kPictureWidth = 58;  // mm at most: three side by side
const QColor kPassed(23, 96, 58), kFailed(156, 43, 26);

QString shown(std::string_view text) { return QString::fromStdString(displayText(std::string(text))); }

QString shown(const AssessmentReport& report, const MessageText& words) { return shown(words.in(report.language)); }

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
    pages.text(box.adjusted(0, 14, 0, 0), shown(report, msg::kOfHundred) + "\n" + shown(resultText(report)),
               {9, false, colour}, Qt::AlignHCenter | Qt::AlignTop);
    pages.paragraph(shown(report, msg::kReportTitle), {17, true}, box.x() - 5);
    pages.skip(1);
    pages.paragraph(factsOf(report), {9.5}, box.x() - 5);
    if (pages.y() < kMarkHeight) pages.skip(kMarkHeight - pages.y());
}

QStringList cellsOf(const AssessmentReport& report, const CriterionScore& each) {
    const Criterion& criterion = *each.criterion;
    QStringList cells;
    cells << shown(criterionText(report, criterion));
    cells << (each.measured.value ? shown(valueText(*criterion.metric, *each.measured.value, report.language))
                                  : shown(report, msg::kNotMeasurable));
    cells << (each.score ? QString::number(*each.score, 'f', 0) : QStringLiteral("–"));
    cells << (each.level ? shown(report, levelText(*each.level)) : QString());
    cells << QString();  // the bar
    cells << (criterion.weight > 0 ? QString::number(criterion.weight) : shown(report, msg::kOnlyLimit));
    cells << (each.lost > 0 ? QStringLiteral("−") + QString::number(each.lost, 'f', 1) : QString());
    cells << shown(placeAndMomentText(report, each.measured));
    return cells;
}

void drawCriteria(PdfPages& pages, const AssessmentReport& report) {
    constexpr int kBarColumn = 4;
    const std::vector<PdfPages::Column> columns = {{44}, {26, Qt::AlignRight}, {13, Qt::AlignRight}, {25},
                                                   {18}, {13, Qt::AlignRight}, {12, Qt::AlignRight}, {31}};
    pages.heading(shown(report, msg::kReportMadeOf), 20);
    QStringList heads;
    for (const MessageText* head : {&msg::kHeadCriterion, &msg::kHeadMeasured, &msg::kHeadScore, &msg::kHeadLevel,
                                    &msg::kHeadWeight, &msg::kHeadLost, &msg::kHeadWhere}) {
        heads << shown(report, *head);
        if (head == &msg::kHeadLevel) heads << QString();
    }
    pages.row(columns, {heads, {8, true, PdfPages::kFaint}});
    for (const CriterionScore& each : report.mark.criteria) {
        PdfPages::Row row{cellsOf(report, each), {8.5}};
        if (each.score && each.level) {
            row.barColumn = kBarColumn;
            row.share = *each.score / 100;
            row.barColour = QColor(shown(levelColour(*each.level)));
        }
        pages.row(columns, row);
    }
    pages.skip(1.5);
    pages.paragraph(shown(weightedMeanText(report.mark, report.language)), {9});
    for (const Criterion* each : report.mark.limitedBy) {
        pages.paragraph(shown(limitedByText(report, *each)), {9, true});
    }
    for (const ErrorText& each : errorTexts(report)) pages.paragraph(shown(each.text), {9});
}

/// Two rows of three, as large as they fit on the page, or one row where that is little.
void drawPictures(PdfPages& pages, const AssessmentReport& report) {
    constexpr double kLeast = 38, kSmall = 27.8, kHeading = 20, kTitle = 5, kAspect = 0.75;  // mm; height to width
    const double room = (PdfPages::kHeight - pages.y() - kHeading) / 2 - kTitle;
    const bool isOneRow = room / kAspect < kLeast;
    const double width = isOneRow ? kSmall : std::min(room / kAspect, kPictureWidth);
    pages.heading(shown(report, msg::kReportDistance), (isOneRow ? 1 : 2) * (kAspect * width + kTitle));
    if (report.pictures.empty()) return pages.paragraph(shown(report.noPictures), {9, false, PdfPages::kFaint});
    std::vector<std::pair<QString, QImage>> pictures;
    for (const ReportPicture& each : report.pictures) {
        const QByteArray png = QByteArray::fromBase64(QByteArray::fromStdString(each.pngBase64));
        pictures.emplace_back(shown(each.title), QImage::fromData(png, "PNG"));
    }
    pages.paragraph(shown(coloursText(report)), {7.5, false, PdfPages::kFaint});
    pages.skip(1);
    pages.pictures(pictures, width, isOneRow ? pictures.size() : 3);
}

void drawAdvice(PdfPages& pages, const AssessmentReport& report) {
    pages.heading(shown(report, msg::kReportNext), 8);
    for (const std::string& step : nextSteps(report)) pages.paragraph("•  " + shown(step), {9});
}

void drawTrend(PdfPages& pages, const AssessmentReport& report) {
    if (!report.trend) return;
    constexpr double kHeight = 27;  // mm
    pages.heading(shown(report, msg::kReportTrend), kHeight + 7);
    const std::string svg = trendSvg(*report.trend, *report.rubric, PdfPages::kWidth, kHeight, report.language);
    pages.drawings({{{}, svg, PdfPages::kWidth, kHeight}});
    for (const std::string& each : trendTexts(*report.trend, report.language))
        pages.paragraph(shown(each), {7.5, false, PdfPages::kFaint});
}

void drawComment(PdfPages& pages, const AssessmentReport& report) {
    if (report.comment.empty()) return;
    pages.heading(shown(report, msg::kReportComment), 8);
    for (const QString& line : QString::fromStdString(report.comment).split('\n')) {
        pages.paragraph(shown(line.toStdString()), {9});
    }
}

/// Room for a comment by hand on the rest of the page. Returns false if that is too little.
bool drawRoomForComment(PdfPages& pages, const AssessmentReport& report) {
    constexpr double kLeast = 22;  // mm, with the heading
    if (PdfPages::kHeight - pages.y() < kLeast) return false;
    if (report.comment.empty()) pages.heading(shown(report, msg::kReportComment), 0);
    return true;
}

void drawSections(PdfPages& pages, const AssessmentReport& report) {
    constexpr double kWidth = 86;  // mm
    std::vector<PdfPages::Drawing> drawings;
    for (const ReportSection& each : report.sections) {
        drawings.push_back(
            {shown(each.title), sectionSvg(each, kWidth, report.language), kWidth, sectionHeight(each, kWidth)});
    }
    if (drawings.empty()) return;
    pages.heading(shown(report, msg::kReportSections), drawings.front().height);
    pages.drawings(drawings);
}

void drawStrip(PdfPages& pages, const AssessmentReport& report) {
    if (!report.strip) return;
    constexpr double kHeight = 36;  // mm
    pages.heading(shown(report, msg::kReportStrip), kHeight);
    pages.drawings(
        {{{}, stripSvg(*report.strip, PdfPages::kWidth, kHeight, report.language), PdfPages::kWidth, kHeight}});
    QStringList marks;
    for (std::size_t i = 0; i < report.strip->marks.size(); ++i)
        marks << shown(markText(i + 1, report.strip->marks[i]));
    pages.paragraph(marks.join("     "), {7.5, false, PdfPages::kFaint});
}

/// Rows of a table that has the same columns side by side.
struct WrappedTable {
    std::vector<PdfPages::Column> columns;  ///< of all groups
    std::vector<QStringList> rows;
};

/// Fills `groups` groups of `columns` from the top, one after another.
WrappedTable wrapped(const std::vector<PdfPages::Column>& columns, std::size_t groups,
                     const std::vector<QStringList>& entries) {
    WrappedTable table;
    for (std::size_t group = 0; group < groups; ++group)
        table.columns.insert(table.columns.end(), columns.begin(), columns.end());
    table.rows.resize((entries.size() + groups - 1) / groups);
    for (std::size_t i = 0; i < entries.size(); ++i) table.rows[i % table.rows.size()] += entries[i];
    return table;
}

/// The measures: those with a place or a moment, then the others. The definitions are left out: docs/assessment.md has
/// them, and the page in HTML.
std::vector<WrappedTable> measuresOf(const AssessmentReport& report) {
    std::vector<QStringList> placed, plain;
    for (const auto& [metric, measured] : report.metrics) {
        if (!measured.value) continue;
        const QString title = shown(metric->titleIn(report.language)),
                      value = shown(valueText(*metric, *measured.value, report.language)),
                      place = shown(placeAndMomentText(report, measured));
        place.isEmpty() ? plain.push_back({title, value}) : placed.push_back({title, value, place});
    }
    return {wrapped({{43}, {19, Qt::AlignRight}, {29}}, 2, placed), wrapped({{43}, {17.6, Qt::AlignRight}}, 3, plain)};
}

/// In letters so small that the report has no third page, but not smaller than the eye can read.
void drawMetrics(PdfPages& pages, const AssessmentReport& report) {
    constexpr std::array kPoints = {6.3, 5.9, 5.5, 5.1};
    constexpr double kBelow = 1;  // mm below a table
    pages.heading(shown(report, msg::kReportMeasures), 20);
    const std::vector<WrappedTable> tables = measuresOf(report);
    QStringList reasons;
    for (const std::string& each : notMeasuredTexts(report)) reasons << shown(each);
    const auto rowOf = [](const QStringList& cells, double points) {
        return PdfPages::Row{.cells = cells, .font = {points}, .gap = 0.05 * points};
    };
    const auto fits = [&](double points) {
        double height = kBelow * static_cast<double>(tables.size()) + pages.heightOf(reasons.join('\n'), {points});
        for (const WrappedTable& table : tables) {
            for (const QStringList& cells : table.rows) height += pages.heightOf(table.columns, rowOf(cells, points));
        }
        return pages.y() + height <= PdfPages::kHeight;
    };
    const auto largest = std::ranges::find_if(kPoints, fits);
    const double points = largest != kPoints.end() ? *largest : kPoints.back();
    for (const WrappedTable& table : tables) {
        for (const QStringList& cells : table.rows) pages.row(table.columns, rowOf(cells, points));
        pages.skip(kBelow);
    }
    for (const QString& each : reasons) pages.paragraph(each, {points, false, PdfPages::kFaint});
}

/// A file. Its writer keeps the margins.
class PdfTarget final : public PageTarget {
public:
    explicit PdfTarget(QPdfWriter& writer) : writer_(writer) {}
    void beginPage(QPainter& painter) override {
        if (painter.isActive()) {
            writer_.newPage();
        } else {
            painter.begin(&writer_);
        }
    }

private:
    QPdfWriter& writer_;
};

}  // namespace

void drawReport(PageTarget& target, const AssessmentReport& report) {
    const Expected<QString> font = reportFont(report.language);
    PdfPages pages(target, shown(footerText(report)), font ? *font : QString());
    drawHead(pages, report);
    drawCriteria(pages, report);
    drawAdvice(pages, report);
    drawComment(pages, report);
    drawTrend(pages, report);
    drawPictures(pages, report);
    const bool hasRoom = drawRoomForComment(pages, report);
    pages.beginPage();
    drawSections(pages, report);
    drawStrip(pages, report);
    drawMetrics(pages, report);
    if (!hasRoom) (void)drawRoomForComment(pages, report);
}

std::string reportPdf(const AssessmentReport& report) {
    const OffscreenApplication application;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(PageTarget::kResolution);
        writer.setPageSize(QPageSize(QPageSize::A4));
        constexpr double kMargin = PageTarget::kMargin;
        writer.setPageMargins(QMarginsF(kMargin, kMargin, kMargin, kMargin), QPageLayout::Millimeter);
        writer.setTitle(shown(Message(msg::kReportPage, report.student).in(report.language)));
        writer.setCreator(shown(report.program));
        PdfTarget target(writer);
        drawReport(target, report);
    }
    return bytes.toStdString();
}

}  // namespace tactooth

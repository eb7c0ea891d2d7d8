// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/make_report.h"

#include <algorithm>

#include "app/common/messages.h"
#include "app/common/report/report_font.h"
#include "app/common/report/report_pdf.h"
#include "app/common/report/report_pictures.h"
#include "assessment/cause/removal_moment.h"
#include "assessment/report/messages.h"
#include "geometry/files/atomic_file.h"
#include "geometry/util/display_text.h"
#include "session/io/commit.h"

namespace tactooth {
namespace {

constexpr double kMeasured = 0.5, kMarked = 0.75;  // about these shares of the time

void showProgress(const AssessedWork& work, double share) {
    if (work.progress) work.progress(share);
}

/// Force and depth over time, with the events and the moments at which points were lost.
WorkStrip stripOf(const AssessedWork& work, const AssessmentReport& report) {
    constexpr std::size_t kColumns = 360, kEvents = 8, kErrors = 4;
    WorkStrip strip = workStrip(*work.track, *work.preparation.original, kColumns, kEvents, report.language);
    std::size_t errors = 0;
    for (const CriterionScore& each : report.mark.criteria) {
        if (!each.measured.moment || each.lost <= 0 || ++errors > kErrors) continue;
        const Message text(msg::kErrorAt, displayText(each.criterion->titleIn(report.language)),
                           valueText(*each.criterion->metric, *each.measured.value, report.language),
                           placeText(report, *each.measured.place));
        strip.marks.push_back({*each.measured.moment, text.in(report.language), true});
    }
    std::ranges::stable_sort(strip.marks, {}, &WorkStrip::Mark::time);
    return strip;
}

}  // namespace

std::string programText() { return std::string("Tactooth ") + TACTOOTH_VERSION + ", " + kCommit; }

void setExercise(AssessedWork& work, const Exercise& exercise) {
    work.expert = exercise.name;
    work.task = exercise.task;
    work.japaneseExpert = exercise.japanese.name;
    work.japaneseTask = exercise.japanese.task;
    work.tolerance = exercise.tolerance;
    work.preparation.tolerance = exercise.tolerance;
    work.preparation.forbidden = exercise.forbidden;
}

Expected<AssessmentReport> makeReport(const AssessedWork& work, const Rubric& rubric, Language language) {
    if (const auto font = reportFont(language); !font) return Unexpected{font.error()};
    const PreparationMeasures measures(work.preparation, {work.track, work.expertTrack, work.sessionInTooth});
    if (measures.surfaces.idealCut.mesh.empty()) return unexpected(msg::kTargetLeavesNothing, work.expert);
    std::vector<MetricResult> results = measureAll(measures);
    showProgress(work, kMeasured);
    std::vector<OverPreparation> errors = traceErrors(results, work.preparation, measures, work.track);
    AssessmentReport report{.student = work.student,
                            .expert = work.expert,
                            .task = work.task,
                            .japaneseExpert = work.japaneseExpert,
                            .japaneseTask = work.japaneseTask,
                            .name = work.name,
                            .date = work.date,
                            .comment = work.comment,
                            .rubric = &rubric,
                            .mark = markOf(rubric, results)};
    if (!report.mark.value) return unexpected(msg::kNothingToJudge, displayText(rubric.name), work.student);
    report.language = language;
    report.metrics = std::move(results);
    report.errors = std::move(errors);
    report.middle = measures.surfaces.middle;
    report.axis = work.preparation.axis;
    report.mesialX = work.preparation.mesialX;
    report.fit = work.fit;
    report.tolerance = work.tolerance;
    showProgress(work, kMarked);
    if (work.track != nullptr) {
        report.seconds = work.track->seconds();
        report.strip = stripOf(work, report);
    }
    const Measured& overMax = measures.deviation.overMax;
    const bool isOver = overMax.value.value_or(0) > work.tolerance;
    report.sections =
        reportSections(work.preparation, measures.surfaces, isOver ? overMax.place : std::nullopt, language);
    report.program = programText();
    Expected<std::vector<ReportPicture>> pictures =
        reportPictures(work.preparation, measures.surfaces, work.tolerance, language);
    if (pictures) {
        report.pictures = std::move(*pictures);
    } else {
        report.noPictures = Message(msg::kNoPictures, pictures.error()).in(language);
    }
    return report;
}

Expected<void> writeReport(const std::filesystem::path& folder, const AssessmentReport& report) {
    if (auto done = writeFile(folder / "report.json", reportJson(report)); !done) return done;
    if (auto done = writeFile(folder / "report.csv", reportCsv(report)); !done) return done;
    if (auto done = writeFile(folder / "report.pdf", reportPdf(report)); !done) return done;
    return writeFile(folder / "report.html", reportHtml(report));
}

}  // namespace tactooth

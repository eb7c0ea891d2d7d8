// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_command.h"

#include "app/cli/cases/assess_class.h"
#include "app/cli/cases/assess_source.h"
#include "app/cli/cases/messages.h"
#include "app/cli/cases/stored_reports.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/report/make_report.h"
#include "assessment/report/assessment_report.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

/// Opens the files before the work starts, so that an obstacle is reported at once.
Expected<void> openFiles(const AssessOptions& options, FileTransaction& files) {
    files.reads(options.student);
    files.reads(options.earlier);
    addInputs(files, options.with);
    if (auto made = files.makeFolder(options.out); !made) return made;
    for (const char* name : kReportFiles) {
        if (auto opened = files.open(options.out / name); !opened) return opened;
    }
    return {};
}

/// Adds the trials before this one, of the reports of a folder.
void addTrend(AssessmentReport& report, std::vector<StoredReport> reports) {
    const StoredReport present = storedReport(report);
    std::vector<StoredReport> trials = earlierTrials(std::move(reports), present);
    if (trials.empty()) return print(stderr, "{}\n", msg::kNoEarlierTrial.english);
    trials.push_back(present);
    report.trend = trialTrend(trials);
}

Expected<AssessmentReport> assess(const AssessOptions& options, const AssessSource& source) {
    std::vector<StoredReport> reports;
    if (!options.earlier.empty()) {
        auto read = storedReportsIn(options.earlier, options.out / "report.json");
        if (!read) return Unexpected{read.error()};
        reports = std::move(*read);
    }
    std::vector<ImportNote> notes = source.importNotes();
    Expected<AssessedWork> work = source.workOf(options.student, notes);
    if (!work) return Unexpected{work.error()};
    printImportNotes(notes);
    work->name = options.name;
    work->comment = options.comment;
    Expected<AssessmentReport> report = makeReport(*work, source.rubric(), options.language);
    if (report && !options.earlier.empty()) addTrend(*report, std::move(reports));
    return report;
}

void printSummary(const AssessOptions& options, const AssessmentReport& report) {
    const Mark& mark = report.mark;
    print("{} against {}: {:.1f} of 100, {} ({}, pass mark {:.0f})\n", report.student, displayText(report.expert),
          *mark.value, mark.passes ? "passed" : "failed", displayText(report.rubric->name), report.rubric->passMark);
    for (const CriterionScore& each : mark.criteria) {
        const std::string title = displayShort(each.criterion->title, 40);
        if (!each.score) {
            print("  {:<40}  not measurable: {}\n", title, each.measured.reason->english);
            continue;
        }
        std::string where =
            each.measured.place ? ", " + placeText(report, *each.measured.place, Language::English) : std::string();
        if (each.measured.moment) where += ", cut at " + momentText(*each.measured.moment);
        print("  {:<40} {:>12} {:4.0f}  {}{}\n", title, valueText(*each.criterion->metric, *each.measured.value),
              *each.score, levelText(*each.level).english, where);
    }
    for (const Criterion* each : mark.limitedBy) print("  The mark is limited by: {}\n", displayText(each->title));
    if (!report.noPictures.empty()) print(stderr, "{}\n", displayText(report.noPictures));
    print("  report: {} and report.pdf\n", displayName(options.out / "report.html"));
}

}  // namespace

int runAssess(const AssessOptions& options) {
    std::error_code fault;
    if (std::filesystem::is_directory(options.student, fault)) {
        if (!options.name.empty()) return reportError(Error(Message(msg::kNameForAFolder)));
        if (!options.earlier.empty()) return reportError(Error(Message(msg::kEarlierForAFolder)));
        const Expected<AssessSource> source = AssessSource::load(options.with);
        if (!source) return reportError(source.error());
        printImportNotes(source->importNotes());
        return runAssessClass(options, *source);
    }
    FileTransaction files;
    if (const auto opened = openFiles(options, files); !opened) return reportError(opened.error());
    const Expected<AssessSource> source = AssessSource::load(options.with);
    if (!source) return reportError(source.error());
    const Expected<AssessmentReport> report = assess(options, *source);
    if (!report) return reportError(report.error());
    if (const auto written = writeReport(options.out, *report); !written) return reportError(written.error());
    if (const auto named = files.commit(); !named) return reportError(named.error());
    if (options.json) {
        writeTo(stdout, reportJson(*report));
    } else {
        printSummary(options, *report);
    }
    return report->mark.passes ? kExitOk : kExitNegative;
}

}  // namespace tactooth

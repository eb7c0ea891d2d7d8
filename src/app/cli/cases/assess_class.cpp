// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_class.h"

#include <algorithm>
#include <deque>
#include <future>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/cases/class_works.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/offscreen_application.h"
#include "assessment/report/class_report.h"
#include "assessment/report/stored_report.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/display_text.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

/// The works and the trials of one student, as far as they have been assessed.
struct StudentTrials {
    std::vector<ClassRow> rows;
    std::vector<StoredReport> reports;
};
using Students = std::map<std::string, StudentTrials>;  // by the names of their folders

/// Measures and marks one work. For any thread.
Expected<AssessmentReport> assessOne(const ClassWork& work, const AssessOptions& options, const AssessSource& source) {
    std::vector<ImportNote> notes;
    Expected<AssessedWork> assessed = source.workOf(work.file, notes);
    if (!assessed) return Unexpected{assessed.error()};
    assessed->name = displayFileName(work.student.empty() ? work.file.stem() : std::filesystem::path(work.student));
    assessed->comment = options.comment;
    return makeReport(*assessed, source.rubric(), options.language);
}

/// Leaves the report of a work. Nothing is left of one that cannot be finished. `trials`: those of the student before
/// this one, to which it is added; null: there are none.
Expected<void> leaveReport(const ClassWork& work, const AssessOptions& options, AssessmentReport& report,
                           std::vector<StoredReport>* trials) {
    const std::filesystem::path folder = options.out / work.student / work.folder;
    FileTransaction files;
    files.reads(work.file);
    addInputs(files, options.with);
    if (auto made = files.makeFolder(folder); !made) return made;
    for (const char* name : kReportFiles) {
        if (auto opened = files.open(folder / name); !opened) return opened;
    }
    std::vector<StoredReport> all;
    if (trials != nullptr) {
        all = *trials;
        all.push_back(storedReport(report));
        if (all.size() > 1) report.trend = trialTrend(all);
    }
    if (auto written = writeReport(folder, report); !written) return written;
    if (auto named = files.commit(); !named) return named;
    if (trials != nullptr) *trials = std::move(all);
    return {};
}

/// Assesses the works of a class, a few at the same time, and returns their reports in the order of the works.
class WorksInTurn {
public:
    WorksInTurn(const std::vector<ClassWork>& works, const AssessOptions& options, const AssessSource& source)
        : works_(works), options_(options), source_(source) {}

    /// The report of the next work; there is one.
    [[nodiscard]] Expected<AssessmentReport> next() {
        while (begun_ < works_.size() && running_.size() < atOnce_) {
            running_.push_back(std::async(
                std::launch::async, [this, &work = works_[begun_]] { return assessOne(work, options_, source_); }));
            ++begun_;
        }
        Expected<AssessmentReport> report = running_.front().get();
        running_.pop_front();
        return report;
    }

private:
    static constexpr std::size_t kMostAtOnce = 8;  // each needs some 300 MB

    const std::vector<ClassWork>& works_;
    const AssessOptions& options_;
    const AssessSource& source_;
    std::size_t atOnce_ = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostAtOnce);
    std::size_t begun_ = 0;
    std::deque<std::future<Expected<AssessmentReport>>> running_;
};

Expected<void> openPages(const std::filesystem::path& folder, const Students& students, FileTransaction& files) {
    if (auto made = files.makeFolder(folder); !made) return made;
    for (const char* name : kClassFiles) {
        if (auto opened = files.open(folder / name); !opened) return opened;
    }
    for (const auto& [student, trials] : students) {
        if (auto made = files.makeFolder(folder / student); !made) return made;
        if (auto opened = files.open(folder / student / kStudentPage); !opened) return opened;
    }
    return {};
}

/// An obstacle is reported before the work starts. Nothing is left.
Expected<void> checkPages(const std::filesystem::path& folder) {
    FileTransaction files;
    return openPages(folder, {}, files);
}

Expected<void> writePages(const std::vector<ClassRow>& rows, const Students& students, const AssessOptions& options,
                          const Rubric& rubric) {
    FileTransaction files;
    if (auto opened = openPages(options.out, students, files); !opened) return opened;
    if (auto done = writeFile(options.out / "class.csv", classCsv(rows, rubric)); !done) return done;
    if (auto done = writeFile(options.out / "class.html", classHtml(rows, rubric, options.language)); !done)
        return done;
    for (const auto& [student, trials] : students) {
        const TrialTrend trend = trialTrend(trials.reports);
        const std::string page = studentHtml(displayFileName(student), trials.rows, rubric,
                                             trend.trials.empty() ? nullptr : &trend, options.language);
        if (auto done = writeFile(options.out / student / kStudentPage, page); !done) return done;
    }
    return files.commit();
}

/// Keeps what the table needs, not the pictures.
ClassRow rowOf(const ClassWork& work, const Expected<AssessmentReport>& report) {
    ClassRow row{.student = work.student, .work = displayFileName(work.file), .folder = work.folder};
    if (report) {
        row.mark = report->mark;
    } else {
        row.fault = report.error();
    }
    return row;
}

void printRow(const ClassRow& row) {
    const std::string name = displayShort(workOf(row), 32);
    if (row.mark) {
        print("{:<32} {:5.1f}  {}\n", name, *row.mark->value, row.mark->passes ? "passed" : "failed");
    } else {
        print("{:<32}     –  {}\n", name, row.fault.in(Language::English));
    }
}

/// The numbers of a work are in its own report.json.
Json jsonOf(const std::vector<ClassRow>& rows) {
    Json json = Json::array();
    for (const ClassRow& row : rows) {
        json.push_back({{"work", workOf(row)},
                        {"folder", row.student.empty() ? row.folder : row.student + "/" + row.folder},
                        {"mark", row.mark ? Json(*row.mark->value) : Json()},
                        {"pass", row.mark ? Json(row.mark->passes) : Json()},
                        {"fault", row.fault.empty() ? Json() : Json(row.fault.in(Language::English))}});
    }
    return json;
}

}  // namespace

int runAssessClass(const AssessOptions& options, const AssessSource& source) {
    const auto works = worksOfClass(options.student);
    if (!works) return reportError(works.error());
    if (const auto writable = checkPages(options.out); !writable) return reportError(writable.error());
    std::vector<ClassRow> rows;
    Students students;
    const OffscreenApplication application;  // of this thread, for all that draw
    WorksInTurn inTurn(*works, options, source);
    for (const ClassWork& work : *works) {
        StudentTrials* student = work.student.empty() ? nullptr : &students[work.student];
        Expected<AssessmentReport> report = inTurn.next();
        if (report) {
            const auto left = leaveReport(work, options, *report, student != nullptr ? &student->reports : nullptr);
            if (!left) report = Unexpected{left.error()};
        }
        rows.push_back(rowOf(work, report));
        if (student != nullptr) student->rows.push_back(rows.back());
        if (!options.json) printRow(rows.back());
    }
    if (const auto done = writePages(rows, students, options, source.rubric()); !done) return reportError(done.error());
    if (options.json) {
        print("{}\n", jsonOf(rows).dump(1, ' ', false, Json::error_handler_t::replace));
    } else {
        print("table: {} and class.csv\n", displayName(options.out / "class.html"));
    }
    const bool isAnyFaulty = std::ranges::any_of(rows, [](const ClassRow& row) { return !row.mark; });
    const bool isAnyFailed =
        std::ranges::any_of(rows, [](const ClassRow& row) { return row.mark && !row.mark->passes; });
    return isAnyFaulty ? kExitBadInput : isAnyFailed ? kExitNegative : kExitOk;
}

}  // namespace tactooth

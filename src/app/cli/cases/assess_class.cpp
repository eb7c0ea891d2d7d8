// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_class.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "app/cli/cases/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "assessment/report/class_report.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/display_text.h"
#include "geometry/util/lower_case.h"
#include "geometry/util/messages.h"
#include "geometry/util/system_reason.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kExtensions = {".ttsession", ".tactooth", ".stl", ".obj", ".ply"};

constexpr std::array kTableFiles = {"class.html", "class.csv"};

/// A folder for each work: its name without the extension, or with it where two works, or a work and a table, have the
/// same name.
std::vector<std::string> foldersOf(const std::vector<std::filesystem::path>& works) {
    std::multiset<std::string> stems(kTableFiles.begin(), kTableFiles.end());
    for (const auto& work : works) stems.insert(toLowerCase(work.stem().native()));
    std::vector<std::string> folders;
    for (const auto& work : works) {
        const bool isOnly = stems.count(toLowerCase(work.stem().native())) == 1;
        folders.push_back(isOnly ? work.stem().native() : work.filename().native());
    }
    return folders;
}

/// Assesses one work and leaves its report. Nothing is left of a report that cannot be finished.
Expected<AssessmentReport> assessOne(const std::filesystem::path& work, const std::filesystem::path& folder,
                                     const AssessOptions& options, const AssessSource& source) {
    FileTransaction files;
    files.reads(work);
    addInputs(files, options.with);
    if (auto made = files.makeFolder(folder); !made) return Unexpected{made.error()};
    for (const char* name : kReportFiles) {
        if (auto opened = files.open(folder / name); !opened) return Unexpected{opened.error()};
    }
    std::vector<ImportNote> notes;
    Expected<AssessedWork> assessed = source.workOf(work, notes);
    if (!assessed) return Unexpected{assessed.error()};
    assessed->name = displayFileName(work.stem());
    assessed->comment = options.comment;
    Expected<AssessmentReport> report = makeReport(*assessed, source.rubric(), options.language);
    if (!report) return report;
    if (auto written = writeReport(folder, *report); !written) return Unexpected{written.error()};
    if (auto named = files.commit(); !named) return Unexpected{named.error()};
    return report;
}

Expected<void> openTable(const std::filesystem::path& folder, FileTransaction& files) {
    if (auto made = files.makeFolder(folder); !made) return made;
    for (const char* name : kTableFiles) {
        if (auto opened = files.open(folder / name); !opened) return opened;
    }
    return {};
}

/// An obstacle is reported before the work starts. Nothing is left.
Expected<void> checkTable(const std::filesystem::path& folder) {
    FileTransaction files;
    return openTable(folder, files);
}

/// Keeps what the table needs, not the pictures.
ClassRow rowOf(const std::string& work, const std::string& folder, const Expected<AssessmentReport>& report) {
    ClassRow row{.work = work, .folder = folder};
    if (report) {
        row.mark = report->mark;
    } else {
        row.fault = report.error();
    }
    return row;
}

void printRow(const ClassRow& row) {
    const std::string name = displayShort(row.work, 32);
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
        json.push_back({{"work", row.work},
                        {"folder", row.folder},
                        {"mark", row.mark ? Json(*row.mark->value) : Json()},
                        {"pass", row.mark ? Json(row.mark->passes) : Json()},
                        {"fault", row.fault.empty() ? Json() : Json(row.fault.in(Language::English))}});
    }
    return json;
}

}  // namespace

Expected<std::vector<std::filesystem::path>> worksIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> works;
    std::error_code fault;
    for (std::filesystem::directory_iterator each(folder, fault), end; !fault && each != end; each.increment(fault)) {
        const std::string name = each->path().filename().native();
        if (name.starts_with('.') || each->is_directory(fault)) continue;
        if (std::ranges::find(kExtensions, toLowerCase(each->path().extension().native())) != kExtensions.end()) {
            works.push_back(each->path());
        }
    }
    if (fault) return unexpected(msg::kFolderNotRead, displayName(folder), systemReason(fault));
    if (works.empty()) return unexpected(msg::kNoWorksInFolder, displayName(folder));
    std::ranges::sort(works);
    return works;
}

int runAssessClass(const AssessOptions& options, const AssessSource& source) {
    const auto works = worksIn(options.student);
    if (!works) return reportError(works.error());
    if (const auto writable = checkTable(options.out); !writable) return reportError(writable.error());
    const std::vector<std::string> folders = foldersOf(*works);
    std::vector<ClassRow> rows;
    for (std::size_t i = 0; i < works->size(); ++i) {
        const auto report = assessOne((*works)[i], options.out / folders[i], options, source);
        rows.push_back(rowOf(displayFileName((*works)[i]), folders[i], report));
        if (!options.json) printRow(rows.back());
    }
    FileTransaction files;
    if (const auto opened = openTable(options.out, files); !opened) return reportError(opened.error());
    if (const auto done = writeFile(options.out / "class.csv", classCsv(rows, source.rubric())); !done)
        return reportError(done.error());
    if (const auto done = writeFile(options.out / "class.html", classHtml(rows, source.rubric(), options.language));
        !done)
        return reportError(done.error());
    if (const auto named = files.commit(); !named) return reportError(named.error());
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

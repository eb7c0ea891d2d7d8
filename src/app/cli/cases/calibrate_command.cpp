// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/calibrate_command.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "app/cli/cases/assess_source.h"
#include "app/cli/cases/class_works.h"
#include "app/cli/cases/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "assessment/agreement/calibration.h"
#include "assessment/agreement/marks_file.h"
#include "assessment/rubric/rubric_file.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/display_text.h"
#include "session/io/unicode_text.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

/// A work, by the name that the marks have for it.
struct NamedWork {
    std::string id;
    std::filesystem::path file;
};

/// The works that have a mark. The marks may name a file with its folder, without it, or without its extension.
Expected<std::vector<NamedWork>> markedWorks(const CalibrateOptions& options,
                                             const std::map<std::string, std::string>& students) {
    std::vector<NamedWork> found;
    const auto add = [&](const std::filesystem::path& file) {
        const std::filesystem::path name = file.lexically_normal();
        for (const std::string& given : {name.native(), name.filename().native(), name.stem().native()}) {
            const std::string id = composed(given);  // as in the marks
            if (!students.contains(id)) continue;
            const bool isNew = std::ranges::find(found, id, &NamedWork::id) == found.end();
            if (isNew) found.push_back({id, file});
            return isNew;
        }
        return true;
    };
    for (const std::filesystem::path& work : options.works) {
        std::error_code fault;
        std::vector<std::filesystem::path> files = {work};
        if (std::filesystem::is_directory(work, fault)) {
            auto inside = worksIn(work);
            if (!inside) return Unexpected{inside.error()};
            files = std::move(*inside);
        }
        for (const std::filesystem::path& file : files) {
            if (!add(file)) return unexpected(msg::kTwoWorksOfOneName, displayName(file));
        }
    }
    if (found.empty()) return unexpected(msg::kNoWorkHasAMark, displayName(options.marks));
    return found;
}

Expected<std::vector<MeasuredWork>> measured(const std::vector<NamedWork>& works, const AssessSource& source,
                                             const std::map<std::string, std::string>& students) {
    std::vector<MeasuredWork> results;
    for (const NamedWork& each : works) {
        std::vector<ImportNote> notes;
        const Expected<AssessedWork> work = source.workOf(each.file, notes);
        if (!work) return Unexpected{work.error()};
        const PreparationMeasures measures(work->preparation, {work->track, work->expertTrack, work->sessionInTooth});
        results.push_back({each.id, students.at(each.id), measureAll(measures)});
    }
    return results;
}

/// One number of an agreement, for three of them side by side.
struct AgreementRow {
    std::string_view id, title;
    std::optional<double> (*value)(const MarkAgreement& agreement);
    std::optional<Interval> (*interval)(const MarkAgreement& agreement);
};

std::optional<Interval> noInterval(const MarkAgreement& /*agreement*/) { return std::nullopt; }

using All = const MarkAgreement&;
constexpr std::array kRows = {
    AgreementRow{"rms", "RMS difference, marks", [](All a) { return a.rms; }, noInterval},
    AgreementRow{"icc", "ICC(2,1)", [](All a) { return a.icc ? a.icc->agreement : std::nullopt; },
                 [](All a) { return a.icc ? a.icc->agreementInterval : std::nullopt; }},
    AgreementRow{"bias", "bias, marks",
                 [](All a) { return a.difference ? std::optional(a.difference->bias) : std::nullopt; },
                 [](All a) { return a.difference ? std::optional(a.difference->biasInterval) : std::nullopt; }},
    AgreementRow{"limit_low", "lower limit of agreement",
                 [](All a) { return a.difference ? std::optional(a.difference->low) : std::nullopt; },
                 [](All a) { return a.difference ? std::optional(a.difference->lowInterval) : std::nullopt; }},
    AgreementRow{"limit_high", "upper limit of agreement",
                 [](All a) { return a.difference ? std::optional(a.difference->high) : std::nullopt; },
                 [](All a) { return a.difference ? std::optional(a.difference->highInterval) : std::nullopt; }},
    AgreementRow{"kappa_linear", "weighted kappa, linear",
                 [](All a) { return a.linearKappa ? std::optional(a.linearKappa->value) : std::nullopt; },
                 [](All a) { return a.linearKappa ? a.linearKappa->interval : std::nullopt; }},
    AgreementRow{"kappa_quadratic", "weighted kappa, quadratic",
                 [](All a) { return a.quadraticKappa ? std::optional(a.quadraticKappa->value) : std::nullopt; },
                 [](All a) { return a.quadraticKappa ? a.quadraticKappa->interval : std::nullopt; }},
    AgreementRow{"sensitivity", "sensitivity",
                 [](All a) {
                     const auto& share = a.failures.sensitivity;
                     return share ? std::optional(share->value) : std::nullopt;
                 },
                 [](All a) {
                     const auto& share = a.failures.sensitivity;
                     return share ? std::optional(share->interval) : std::nullopt;
                 }},
    AgreementRow{"specificity", "specificity",
                 [](All a) {
                     const auto& share = a.failures.specificity;
                     return share ? std::optional(share->value) : std::nullopt;
                 },
                 [](All a) {
                     const auto& share = a.failures.specificity;
                     return share ? std::optional(share->interval) : std::nullopt;
                 }},
    AgreementRow{"area_under_curve", "area under the curve", [](All a) { return a.areaUnderCurve; }, noInterval},
};

std::string cellOf(const AgreementRow& row, const MarkAgreement& agreement) {
    const auto value = row.value(agreement);
    if (!value) return "–";
    const auto interval = row.interval(agreement);
    if (!interval) return fmt::format("{:.2f}", *value);
    return fmt::format("{:.2f} ({:.2f} to {:.2f})", *value, interval->low, interval->high);
}

void printResult(const CalibrateOptions& options, const Calibration& result) {
    print("{} works of {} students, marked by {} teachers; {} folds\n", result.works.size(), result.students,
          result.teachers.teachers, result.folds);
    if (result.notMeasured > 0)
        print("{} works have no mark by the start rubric and are left out\n", result.notMeasured);
    print("\n{:<42} {:>7} {:>9}\n", "criterion", "weight", "widening");
    for (const CriterionFit& each : result.fit.criteria) {
        print("{:<42} {:>7.1f} {:>9.2f}\n", displayShort(each.start->title, 42), each.weight, each.widening);
    }
    print("\n{:<27} {:<26} {:<26} {}\n", "program with the teachers", "new students", "start rubric", "fitted works");
    for (const AgreementRow& row : kRows) {
        print("{:<27} {:<26} {:<26} {}\n", row.title, cellOf(row, result.heldOut), cellOf(row, result.start),
              cellOf(row, result.fitted));
    }
    const TeacherAgreement& teachers = result.teachers;
    if (teachers.icc && teachers.icc->agreement) {
        print("\nteachers among each other: ICC(2,1) {:.2f} over {} works", *teachers.icc->agreement,
              teachers.commonWorks);
        if (teachers.kappa) print(", mean quadratic kappa {:.2f}", teachers.kappa->value);
        print("\n");
    }
    if (result.helps()) {
        print("The fit comes closer to the teachers than the start rubric, for students it has not seen.\n");
    } else {
        print(
            "The fit does not come closer to the teachers than the start rubric, for students it has not seen: keep "
            "the start rubric.\n");
    }
    print("fitted rubric: {}\n", displayName(options.out));
}

Json jsonOf(const Calibration& result) {
    const auto agreement = [](const MarkAgreement& all) {
        Json json = {{"works", all.works}};
        for (const AgreementRow& row : kRows) {
            const auto value = row.value(all);
            const auto interval = row.interval(all);
            json[std::string(row.id)] = value ? Json(*value) : Json();
            if (interval) json[std::string(row.id) + "_interval"] = {interval->low, interval->high};
        }
        for (std::size_t i = 0; i < kMarkLevels; ++i) {
            for (std::size_t k = 0; k < kMarkLevels; ++k) json["levels"][i][k] = all.levels.at(i, k);
        }
        return json;
    };
    Json json = {{"works", result.works.size()},
                 {"students", result.students},
                 {"folds", result.folds},
                 {"not_measured", result.notMeasured},
                 {"helps", result.helps()},
                 {"new_students", agreement(result.heldOut)},
                 {"start", agreement(result.start)},
                 {"fitted", agreement(result.fitted)}};
    const auto& icc = result.teachers.icc;
    json["teachers"] = {{"count", result.teachers.teachers},
                        {"common_works", result.teachers.commonWorks},
                        {"icc", icc && icc->agreement ? Json(*icc->agreement) : Json()},
                        {"kappa", result.teachers.kappa ? Json(result.teachers.kappa->value) : Json()}};
    for (const CriterionFit& each : result.fit.criteria) {
        json["criteria"].push_back({{"title", each.start->title},
                                    {"metric", each.start->metric->id},
                                    {"weight", each.weight},
                                    {"widening", each.widening}});
    }
    return json;
}

}  // namespace

int runCalibrate(const CalibrateOptions& options) {
    FileTransaction files;
    files.reads(options.marks);
    addInputs(files, options.with);
    for (const std::filesystem::path& work : options.works) files.reads(work);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    auto marks = readMarks(options.marks);
    if (!marks) return reportError(marks.error());
    const std::map<std::string, std::string> students = studentsOf(*marks);
    const auto works = markedWorks(options, students);
    if (!works) return reportError(works.error());
    const Expected<AssessSource> source = AssessSource::load(options.with);
    if (!source) return reportError(source.error());
    printImportNotes(source->importNotes());
    const auto results = measured(*works, *source, students);
    if (!results) return reportError(results.error());
    const std::size_t all = marks->size();
    std::erase_if(*marks, [&](const TeacherMark& mark) {  // of other works of the school
        return std::ranges::find(*works, mark.work, &NamedWork::id) == works->end();
    });
    const Expected<Calibration> result = calibrate(source->rubric(), *results, *marks);
    if (!result) return reportError(result.error());
    if (const auto done = writeFile(options.out, rubricText(result->fit.rubric)); !done)
        return reportError(done.error());
    if (const auto named = files.commit(); !named) return reportError(named.error());
    if (marks->size() < all) print(stderr, "{} marks are of works that were not given.\n", all - marks->size());
    if (options.json) {
        print("{}\n", jsonOf(*result).dump(1, ' ', false, Json::error_handler_t::replace));
    } else {
        printResult(options, *result);
    }
    return kExitOk;
}

}  // namespace tactooth

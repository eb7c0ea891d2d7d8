// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/learned_command.h"

#include <algorithm>

#include "app/cli/cases/messages.h"
#include "app/cli/cases/stored_reports.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "assessment/report/learning_page.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/display_text.h"
#include "geometry/util/number_text.h"

namespace tactooth {
namespace {

constexpr double kFalseAlarm = 0.05;

Expected<LearningTest> testOf(const LearnedOptions& options) {
    const CusumRates rates{options.acceptable, options.unacceptable};
    const std::optional<CusumPlan> cusum = planCusum(rates);
    if (!cusum) return unexpected(msg::kRatesNotInOrder, numberText(rates.acceptable), numberText(rates.unacceptable));
    const auto learning = planLearning(options.adequate, options.inadequate, options.trials, kFalseAlarm);
    if (!learning) {
        return unexpected(msg::kRatesTooClose, numberText(options.adequate), numberText(options.inadequate),
                          options.trials, numberText(kFalseAlarm));
    }
    return LearningTest{rates, *cusum, options.adequate, *learning};
}

Expected<std::vector<StudentLearning>> studentsOf(const LearnedOptions& options, const LearningTest& test) {
    const Expected<std::vector<StoredReport>> reports = storedReportsIn(options.folder);
    if (!reports) return Unexpected{reports.error()};
    if (reports->empty()) return unexpected(msg::kNoReportsInFolder, displayName(options.folder));
    std::vector<StudentLearning> students = learningOf(*reports, test);
    for (const StudentLearning& each : students) {
        if (each.trials.size() <= options.trials) continue;
        const std::string name = each.name.empty() ? displayName(options.folder) : displayText(each.name);
        return unexpected(msg::kTrialsExceedPlan, name, each.trials.size(), options.trials);
    }
    return students;
}

void printSummary(const std::vector<StudentLearning>& students, const LearningTest& test) {
    for (const StudentLearning& each : students) {
        const std::string name = each.name.empty() ? "(no name)" : displayText(each.name);
        print("{}: {}\n", name, displayText(each.trials.back().expert));
        for (const std::string& text : learningTexts(each, test, Language::English)) print("  {}\n", text);
    }
}

}  // namespace

int runLearned(const LearnedOptions& options) {
    const Expected<LearningTest> test = testOf(options);
    if (!test) return reportError(test.error());
    FileTransaction files;
    files.reads(options.folder);
    if (const auto made = files.makeFolder(options.out); !made) return reportError(made.error());
    for (const char* name : {"learned.html", "learned.json"}) {
        if (const auto opened = files.open(options.out / name); !opened) return reportError(opened.error());
    }
    const Expected<std::vector<StudentLearning>> students = studentsOf(options, *test);
    if (!students) return reportError(students.error());
    const std::string json = learningJson(*students, *test);
    if (const auto done = writeFile(options.out / "learned.json", json); !done) return reportError(done.error());
    if (const auto done = writeFile(options.out / "learned.html", learningHtml(*students, *test, options.language));
        !done) {
        return reportError(done.error());
    }
    if (const auto named = files.commit(); !named) return reportError(named.error());
    if (options.json) {
        writeTo(stdout, json);
    } else {
        printSummary(*students, *test);
        print("page: {} and learned.json\n", displayName(options.out / "learned.html"));
    }
    const bool areAll =
        std::ranges::all_of(*students, [](const StudentLearning& each) { return each.curve.learntAt.has_value(); });
    return areAll ? kExitOk : kExitNegative;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/cause/removal_moment.h"
#include "assessment/preparation/scan_alignment.h"
#include "assessment/process/work_strip.h"
#include "assessment/report/report_section.h"
#include "assessment/report/trial_trend.h"
#include "assessment/rubric/rubric.h"

namespace tactooth {

/// Where the colours of the pictures end, mm from the ideal surface.
inline constexpr double kColourRange = 0.5;

/// A picture of a report.
struct ReportPicture {
    std::string title;
    std::string pngBase64;
};

/// The results of an assessment, for files that people and programs read.
struct AssessmentReport {
    std::string student;                                 ///< name of the file
    std::string expert;                                  ///< name of the file, or of the exercise
    std::string task = {};                               ///< of the exercise; empty: there is none
    std::string japaneseExpert = {}, japaneseTask = {};  ///< empty: the same as these
    std::string name = {};                               ///< of the student; empty: not known
    std::string date = {};                               ///< of the work; empty: not known
    std::string comment = {};                            ///< of the teacher; empty: there is none
    const Rubric* rubric = nullptr;                      ///< not null
    Mark mark = {};
    std::vector<MetricResult> metrics = {};
    std::vector<OverPreparation> errors = {};  ///< the largest first
    Vec3 middle = Vec3::Zero();                ///< of the preparation, mm
    Vec3 axis = Vec3::UnitZ();
    double mesialX = 1;
    std::optional<ScanFit> fit = {};     ///< how well a surface from a file lies on the uncut tooth
    std::optional<double> seconds = {};  ///< length of the session; nothing without one
    double tolerance = 0;                ///< mm: what is nearer to the ideal surface is white in the pictures
    std::vector<ReportPicture> pictures = {};
    std::string noPictures = {};  ///< why there are none
    std::vector<ReportSection> sections = {};
    std::optional<WorkStrip> strip = {};    ///< nothing without a session
    std::optional<TrialTrend> trend = {};   ///< nothing without earlier trials
    std::string program = {};               ///< version and commit
    Language language = Language::English;  ///< of the pages; JSON and CSV are in English
};

// Without a language, the texts are in that of the report.

/// In words: "mesiobuccal".
[[nodiscard]] std::string placeText(const AssessmentReport& report, const Vec3& place, Language language);
[[nodiscard]] inline std::string placeText(const AssessmentReport& report, const Vec3& place) {
    return placeText(report, place, report.language);
}
/// "2:14"
[[nodiscard]] std::string momentText(double seconds);
/// "distobuccal, 2:14", whichever of both there is.
[[nodiscard]] std::string placeAndMomentText(const AssessmentReport& report, const Measured& measured,
                                             Language language);
[[nodiscard]] inline std::string placeAndMomentText(const AssessmentReport& report, const Measured& measured) {
    return placeAndMomentText(report, measured, report.language);
}
/// How an error was made, in a sentence; empty where nothing is known. Only errors of a recorded session have a cause.
[[nodiscard]] std::string causeText(const AssessmentReport& report, const CriterionScore& error, Language language);
/// "Buccal wall 0.42 mm over-prepared (distobuccal) between 2:14 and 2:19; force 1.8 N, bur tilted 14 degrees."
[[nodiscard]] std::string overPreparationText(const AssessmentReport& report, const OverPreparation& error,
                                              Language language);
/// What was lost at a place, and how that came.
struct ErrorText {
    std::string text;     ///< a sentence
    std::string command;  ///< shows the tooth when that was done; empty where no recording has it
};
/// The over-preparations, where they have cost something, and then the errors that cost most; at most five.
[[nodiscard]] std::vector<ErrorText> errorTexts(const AssessmentReport& report, Language language);
[[nodiscard]] inline std::vector<ErrorText> errorTexts(const AssessmentReport& report) {
    return errorTexts(report, report.language);
}
/// "0.42 mm"; a share of 0 to 1 in %.
[[nodiscard]] std::string valueText(const PreparationMetric& metric, double value,
                                    Language language = Language::English);

/// A line over the report: "Task", "Follow the central fissure".
struct ReportFact {
    std::string_view title;
    std::string value;
};
/// The first two are the work and what it is compared with.
[[nodiscard]] std::vector<ReportFact> reportFacts(const AssessmentReport& report);
/// A sentence.
[[nodiscard]] std::string weightedMeanText(const Mark& mark, Language language = Language::English);
/// "The mark is limited by: Pulp"
[[nodiscard]] std::string limitedByText(const AssessmentReport& report, const Criterion& criterion);
/// "Pulp (critical)"
[[nodiscard]] std::string criterionText(const AssessmentReport& report, const Criterion& criterion);
/// "passed, pass mark 65"
[[nodiscard]] std::string resultText(const AssessmentReport& report);
/// What the colours of the pictures mean, in a sentence.
[[nodiscard]] std::string coloursText(const AssessmentReport& report);
/// "1  0:04  Dentin reached"
[[nodiscard]] std::string markText(std::size_t number, const WorkStrip::Mark& mark);
/// The measures without a value, those with the same reason in one sentence.
[[nodiscard]] std::vector<std::string> notMeasuredTexts(const AssessmentReport& report);
[[nodiscard]] std::string footerText(const AssessmentReport& report);
/// "#2f7d4f"
[[nodiscard]] std::string_view levelColour(Level level);

inline constexpr int kReportFormat = 1;  ///< of the form of report.json

// Three of the four forms; docs/assessment.md describes them.
[[nodiscard]] std::string reportJson(const AssessmentReport& report);
[[nodiscard]] std::string reportCsv(const AssessmentReport& report);
/// One page without other files or scripts.
[[nodiscard]] std::string reportHtml(const AssessmentReport& report);

}  // namespace tactooth

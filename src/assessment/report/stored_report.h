// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/report/assessment_report.h"
#include "geometry/util/expected.h"

namespace tactooth {

/// What a later program needs of a report.json.
struct StoredReport {
    struct Criterion {
        std::string metric;           ///< its id
        std::optional<double> score;  ///< 0..100; nothing where it could not be measured
        double lost = 0;              ///< points of the mark
        bool limitedMark = false;     ///< it has lowered the mark
    };
    std::string place = {};  ///< the file, for people
    std::string student;     ///< name of the file of the work
    std::string name = {};   ///< of the student; empty: not known
    std::string date = {};   ///< of the work; empty: not known
    std::string expert;      ///< what it was compared with
    std::string rubric;      ///< its name
    std::string ranges;      ///< all that makes a mark of measures, as one text: reports with the same one compare
    double passMark = 0;
    double mark = 0;  ///< 0..100
    bool passes = false;
    std::vector<Criterion> criteria;  ///< in the order of the rubric

    /// Whether both are of the same work.
    [[nodiscard]] bool isSameWork(const StoredReport& other) const {
        return student == other.student && name == other.name && date == other.date && !date.empty();
    }
};

/// Reads a report.json. `name` stands for the file in messages. Fails with one sentence.
[[nodiscard]] Expected<StoredReport> readStoredReport(std::string_view json, const std::string& name);
/// The same of a report that has a mark.
[[nodiscard]] StoredReport storedReport(const AssessmentReport& report);

/// The trials of comparable reports, in this order.
[[nodiscard]] TrialTrend trialTrend(std::span<const StoredReport> reports);

/// Why the marks of two reports cannot be compared; nothing if they can.
[[nodiscard]] std::optional<Message> whyNotComparable(const StoredReport& one, const StoredReport& other);

/// Whether a trial came before another: by the dates of the works, those without a date first; else by the places of
/// their reports.
[[nodiscard]] bool isEarlier(const StoredReport& one, const StoredReport& other);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/agreement/interval.h"
#include "geometry/util/message.h"

namespace tactooth {

/// The marks of a student's trials of one exercise by one rubric.
struct TrialTrend {
    struct Score {
        std::optional<double> value;  ///< 0..100
        double cost = 0;  ///< points of the mark; of a criterion that has limited the mark, all points to 100
    };
    struct Trial {
        double mark;
        bool passes;
        std::vector<Score> scores;  ///< in the order of the rubric
    };
    std::vector<Trial> trials;  ///< in the order of time, the present one last
};

/// What the last marks say about a student.
struct RecentMarks {
    std::size_t trials;  ///< the last ones, kRecentTrials at most
    double median;
    double low, high;  ///< the least and the greatest of them
    /// Where the student's median lies with a confidence of at least 95 %, if the trials do not depend on each other:
    /// between two of the marks, whatever their distribution (W. R. Thompson, 1936). Nothing for fewer than six.
    std::optional<Interval> interval;
};
inline constexpr std::size_t kRecentTrials = 10;
/// `marks`: in the order of time, at least one.
[[nodiscard]] RecentMarks recentMarks(std::span<const double> marks);
[[nodiscard]] RecentMarks recentMarks(const TrialTrend& trend);

/// In sentences.
[[nodiscard]] std::vector<std::string> trendTexts(const TrialTrend& trend, Language language);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "assessment/preparation/preparation_metrics.h"

namespace tactooth {

/// The levels of the published rubrics: ideal, acceptable, to be corrected, fail.
enum class Level { Ideal, Acceptable, Correct, Fail };
[[nodiscard]] const MessageText& levelText(Level level);

/// Which values of a metric are how good. The score is 100 inside the innermost range. Outside of it, it falls in
/// straight lines to 85, 65 and 0 at the ends of the next ranges, so that a hundredth of a millimetre never costs a
/// level.
class LevelRanges {
public:
    struct Range {
        double low, high;
        bool operator==(const Range&) const = default;
    };
    /// From the ideal range outwards. On each side the four ends differ and go outwards, or all four are equal: then
    /// that side has no limit.
    explicit LevelRanges(const std::array<Range, 4>& ranges) : ranges_(ranges) {}

    [[nodiscard]] static bool areNested(const std::array<Range, 4>& ranges);

    /// 0..100
    [[nodiscard]] double scoreOf(double value) const;
    [[nodiscard]] Level levelOf(double value) const;
    [[nodiscard]] const std::array<Range, 4>& ranges() const { return ranges_; }
    [[nodiscard]] bool hasLowerLimit() const { return ranges_[0].low != ranges_[3].low; }
    [[nodiscard]] bool hasUpperLimit() const { return ranges_[0].high != ranges_[3].high; }

private:
    std::array<Range, 4> ranges_;
};

/// One criterion of a rubric.
struct Criterion {
    std::string title;
    const PreparationMetric* metric;  ///< not null
    double weight = 0;
    LevelRanges levels;
    bool critical = false;           ///< a score of 0 limits the mark to Rubric::criticalMark
    bool limitsMark = false;         ///< the mark is not better than this score
    std::string japaneseTitle = {};  ///< empty: the same as `title`

    [[nodiscard]] const std::string& titleIn(Language language) const {
        return language == Language::Japanese && !japaneseTitle.empty() ? japaneseTitle : title;
    }
};

/// How a preparation is marked.
struct Rubric {
    std::string name;
    double passMark = 65;      ///< 0..100
    double criticalMark = 40;  ///< the best mark after a critical error; less than passMark
    std::vector<Criterion> criteria;
    std::string japaneseName = {};  ///< empty: the same as `name`

    [[nodiscard]] const std::string& nameIn(Language language) const {
        return language == Language::Japanese && !japaneseName.empty() ? japaneseName : name;
    }
};

/// How good a preparation is by one criterion.
struct CriterionScore {
    const Criterion* criterion;
    Measured measured;
    std::optional<double> score;  ///< 0..100; nothing where the value cannot be measured
    std::optional<Level> level;
    double lost = 0;  ///< points of the mark that this criterion costs, before any limit
};

/// A mark, and what it is made of.
struct Mark {
    std::optional<double> value;  ///< 0..100, in tenths; nothing if no criterion with a weight can be measured
    bool passes = false;
    double judgedShare = 0;          ///< of the weights, of criteria that could be measured, 0..1
    std::optional<double> weighted;  ///< the weighted mean of the scores, before any limit
    std::vector<CriterionScore> criteria;
    std::vector<const Criterion*> limitedBy;  ///< those that have lowered the mark below the weighted mean
};

/// `results`: of measureAll. `rubric` outlives the mark.
[[nodiscard]] Mark markOf(const Rubric& rubric, const std::vector<MetricResult>& results);

}  // namespace tactooth

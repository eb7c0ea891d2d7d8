// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/agreement/interval.h"
#include "assessment/rubric/rubric.h"
#include "assessment/study/hand_habits.h"

namespace tactooth {

/// A hand of a study.
struct StudyHand {
    std::string name;                   ///< "beginner-02", "tremor-3"; also of its file
    HandLevel level = {};               ///< of the habits that are not varied
    const HandHabit* varied = nullptr;  ///< the one habit that differs; null: a hand of its level
    HandHabits habits;
    std::uint64_t seed = 0;
};

/// The hands of a study: `count` of each level, then for each habit an expert's hand with four amounts of this habit
/// alone: none of it or an expert's, a student's, a beginner's, and half as much again. Equal arguments give equal
/// hands.
[[nodiscard]] std::vector<StudyHand> studyHands(std::size_t count, std::uint64_t seed);

/// What a hand has done, with its mark.
struct StudyTrial {
    StudyHand hand;
    std::vector<MetricResult> metrics;
    Mark mark;
};

/// How well a number separates the levels.
struct LevelContrast {
    std::array<std::optional<double>, kHandLevels.size()> medians;  ///< of the hands for which it can be measured
    std::optional<double> area;        ///< areaUnderCurve of experts over beginners: 1 or 0 separates fully, 0.5 not
    std::optional<Interval> interval;  ///< of `area`, by bootstrap
};
/// `valueOf`: of a trial; nothing where there is none. Only the hands of the levels count.
using TrialValue = std::function<std::optional<double>(const StudyTrial&)>;
[[nodiscard]] LevelContrast contrastOf(const std::vector<StudyTrial>& trials, const TrialValue& valueOf);
/// The value of the metric in row `index` of preparationMetrics.
[[nodiscard]] TrialValue metricValue(std::size_t index);
[[nodiscard]] std::optional<double> markValue(const StudyTrial& trial);

/// Whether a metric shows the habit that it must show.
struct ShownHabit {
    const HandHabit* habit;
    std::size_t metric;  ///< row of preparationMetrics
    bool rises;
    std::vector<std::optional<double>> values = {};  ///< with growing amounts of the habit
    /// Kendall's tau of amount and value (M. G. Kendall, "A new measure of rank correlation", Biometrika 30, 1938);
    /// nothing where a value cannot be measured.
    std::optional<double> tau = {};
    /// Whether it could be measured for all hands: a short cavity, for instance, has no isthmus to measure.
    [[nodiscard]] bool isMeasured() const;
    /// In the direction that it must have, with at most one pair of amounts in the wrong order, and the most of the
    /// habit beyond the least.
    bool isShown = false;
};
/// Those that the exercise can measure.
[[nodiscard]] std::vector<ShownHabit> shownHabits(const std::vector<StudyTrial>& trials);

/// Whether the marks put each expert above each beginner, and each habit is shown by the metrics that must show it.
[[nodiscard]] bool passesSelfTest(const std::vector<StudyTrial>& trials);

}  // namespace tactooth

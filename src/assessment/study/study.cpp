// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/study.h"

#include <fmt/core.h>

#include <algorithm>

#include "assessment/agreement/failure_detection.h"
#include "assessment/agreement/median.h"
#include "assessment/agreement/seeded_random.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kMost = 1.5;  // of a beginner's habit: the largest amount that is varied alone

std::string_view wordOf(HandLevel level) {
    switch (level) {
        case HandLevel::Expert:
            return "expert";
        case HandLevel::Student:
            return "student";
        case HandLevel::Beginner:
            break;
    }
    return "beginner";
}

std::vector<double> valuesOf(const std::vector<StudyTrial>& trials, HandLevel level, const TrialValue& valueOf) {
    std::vector<double> values;
    for (const StudyTrial& each : trials) {
        if (each.hand.varied != nullptr || each.hand.level != level) continue;
        if (const auto value = valueOf(each)) values.push_back(*value);
    }
    return values;
}

std::size_t rowOf(std::string_view metric) {
    const auto rows = preparationMetrics();
    const auto found = std::ranges::find(rows, metric, &PreparationMetric::id);
    TACTOOTH_ASSERT(found != rows.end());
    return static_cast<std::size_t>(found - rows.begin());
}

/// Pairs in the order of their index less pairs in the other one; ties count for neither.
int orderOf(const std::vector<double>& values) {
    int order = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t k = i + 1; k < values.size(); ++k) order += (values[k] > values[i]) - (values[k] < values[i]);
    }
    return order;
}

ShownHabit shownHabit(const HandHabit& habit, const HabitEffect& effect, const std::vector<StudyTrial>& trials) {
    ShownHabit shown{.habit = &habit, .metric = rowOf(effect.metric), .rises = effect.rises};
    std::vector<double> known;
    for (const StudyTrial& each : trials) {
        if (each.hand.varied != &habit) continue;
        shown.values.push_back(each.metrics[shown.metric].measured.value);
        if (shown.values.back()) known.push_back(*shown.values.back());
    }
    if (known.size() < shown.values.size() || known.size() < 2) return shown;
    const auto pairs = static_cast<int>(known.size() * (known.size() - 1) / 2);
    const int order = effect.rises ? orderOf(known) : -orderOf(known);
    shown.tau = static_cast<double>(orderOf(known)) / pairs;
    const bool isBeyond = effect.rises ? known.back() > known.front() : known.back() < known.front();
    shown.isShown = isBeyond && order >= pairs - 2;
    return shown;
}

}  // namespace

std::vector<StudyHand> studyHands(std::size_t count, std::uint64_t seed) {
    SeededRandom random(seed);
    std::vector<StudyHand> hands;
    for (const HandLevel level : kHandLevels) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t own = random.next();
            hands.push_back(
                {fmt::format("{}-{:02}", wordOf(level), i + 1), level, nullptr, habitsOfHand(level, own), own});
        }
    }
    for (const HandHabit& each : handHabits()) {
        const std::uint64_t own = random.next();  // the same tremor for all amounts
        const auto& [expert, student, beginner] = each.levels;
        std::size_t number = 0;
        for (const double amount : {expert, student, beginner, kMost * beginner}) {
            StudyHand hand{fmt::format("{}-{}", each.id, ++number), HandLevel::Expert, &each,
                           usualHabits(HandLevel::Expert), own};
            hand.habits.*each.value = amount;
            hands.push_back(std::move(hand));
        }
    }
    return hands;
}

LevelContrast contrastOf(const std::vector<StudyTrial>& trials, const TrialValue& valueOf) {
    LevelContrast contrast;
    for (const HandLevel level : kHandLevels)
        contrast.medians[static_cast<std::size_t>(level)] = medianOf(valuesOf(trials, level, valueOf));
    const std::vector<double> experts = valuesOf(trials, HandLevel::Expert, valueOf);
    const std::vector<double> beginners = valuesOf(trials, HandLevel::Beginner, valueOf);
    contrast.area = areaUnderCurve(experts, beginners);
    if (!contrast.area) return contrast;
    contrast.interval = bootstrapInterval(experts.size() + beginners.size(), [&](std::span<const std::size_t> chosen) {
        std::vector<double> upper, lower;
        for (const std::size_t i : chosen) {
            if (i < experts.size()) {
                upper.push_back(experts[i]);
            } else {
                lower.push_back(beginners[i - experts.size()]);
            }
        }
        return areaUnderCurve(upper, lower);
    });
    return contrast;
}

TrialValue metricValue(std::size_t index) {
    return [index](const StudyTrial& trial) { return trial.metrics[index].measured.value; };
}

std::optional<double> markValue(const StudyTrial& trial) { return trial.mark.value; }

bool ShownHabit::isMeasured() const {
    return std::ranges::all_of(values, [](const std::optional<double>& value) { return value.has_value(); });
}

std::vector<ShownHabit> shownHabits(const std::vector<StudyTrial>& trials) {
    std::vector<ShownHabit> all;
    for (const HandHabit& habit : handHabits()) {
        for (const HabitEffect& effect : habit.effects) {
            if (effect.metric.empty()) continue;
            ShownHabit shown = shownHabit(habit, effect, trials);
            if (shown.isMeasured()) all.push_back(std::move(shown));
        }
    }
    return all;
}

bool passesSelfTest(const std::vector<StudyTrial>& trials) {
    if (contrastOf(trials, markValue).area != 1) return false;
    return std::ranges::all_of(shownHabits(trials), &ShownHabit::isShown);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "geometry/util/message.h"

namespace tactooth {

/// How a synthetic hand works. It follows the path of the bur through the ideal preparation, with these faults.
struct HandHabits {
    double tremor = 0;  ///< mm, root mean square in each direction, at 8 to 12 Hz
    double delay = 0;   ///< s until the hand answers a change of the force; positive
    double force = 0;   ///< N that the hand presses with before it holds back; positive
    double layer = 0;   ///< mm that it takes away in one pass; positive
    double deeper = 0;  ///< mm deeper than the ideal floor
    double wider = 0;   ///< mm beyond the ideal outline, to all sides
    double undone = 0;  ///< share of the length of the work that it leaves out at its end, 0..1
    double uneven = 0;  ///< mm, root mean square in each direction, that it strays from the path within some mm of it
};

/// How good a hand is.
enum class HandLevel { Expert, Student, Beginner };
inline constexpr std::array kHandLevels = {HandLevel::Expert, HandLevel::Student, HandLevel::Beginner};
[[nodiscard]] const MessageText& titleOf(HandLevel level);

/// A metric that must show a habit.
struct HabitEffect {
    std::string_view metric;  ///< PreparationMetric::id; empty: none
    bool rises = true;        ///< with the habit; false: falls
};

/// One habit: a row of the table from which hands, tables and the self-test are made.
struct HandHabit {
    std::string_view id;  ///< in files; stable
    const MessageText* title;
    std::string_view unit;  ///< "mm", "s", "N", or "1"
    double HandHabits::*value;
    std::array<double, 3> levels;  ///< of expert, student and beginner
    std::array<HabitEffect, 3> effects;

    [[nodiscard]] double at(HandLevel level) const { return levels[static_cast<std::size_t>(level)]; }
};
[[nodiscard]] std::span<const HandHabit> handHabits();

/// The habits of a level, each at its usual value.
[[nodiscard]] HandHabits usualHabits(HandLevel level);
/// The same for one hand of many: each habit is between 0.85 and 1.15 times the usual value, by `seed`.
[[nodiscard]] HandHabits habitsOfHand(HandLevel level, std::uint64_t seed);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/study/hand_habits.h"

#include "assessment/agreement/seeded_random.h"
#include "assessment/study/messages.h"

namespace tactooth {
namespace {

// Expert: 0.3 to 1 N, a physiological tremor of some hundredths of a millimetre, layers of half a bur's head. A
// student's `deeper`, `wider`, `undone` and `uneven` together leave a surface 0.2 to 0.37 mm (RMS) off the ideal one;
// students have been measured at 0.27 mm (0.18 to 0.40). A beginner's are about twice that. The other values are chosen
// (docs/assessment.md).
constexpr std::array kHabits = {
    HandHabit{"tremor",
              &msg::kHabitTremor,
              "mm",
              &HandHabits::tremor,
              {0.01, 0.03, 0.08},
              {HabitEffect{"ldlj", false}, {"path_length"}, {"force_sd"}}},
    HandHabit{"delay",
              &msg::kHabitDelay,
              "s",
              &HandHabits::delay,
              {0.1, 0.2, 0.35},
              {HabitEffect{"force_peak"}, {"force_sd"}}},
    HandHabit{"force",
              &msg::kHabitForce,
              "N",
              &HandHabits::force,
              {0.7, 1.4, 2.4},
              {HabitEffect{"force_mean"}, {"force_p95"}, {"force_peak"}}},
    HandHabit{
        "layer", &msg::kHabitLayer, "mm", &HandHabits::layer, {0.4, 0.7, 1.2}, {HabitEffect{"path_length", false}}},
    HandHabit{"deeper",
              &msg::kHabitDeeper,
              "mm",
              &HandHabits::deeper,
              {0, 0.27, 0.54},
              {HabitEffect{"floor_depth_median"}, {"over_max"}, {"over_volume"}}},
    HandHabit{"wider",
              &msg::kHabitWider,
              "mm",
              &HandHabits::wider,
              {0, 0.23, 0.46},
              {HabitEffect{"over_volume"}, {"dice", false}, {"extent_bl"}}},
    HandHabit{"undone",
              &msg::kHabitUndone,
              "1",
              &HandHabits::undone,
              {0, 0.08, 0.25},
              {HabitEffect{"under_volume"}, {"cleared_share", false}}},
    HandHabit{"uneven",
              &msg::kHabitUneven,
              "mm",
              &HandHabits::uneven,
              {0.02, 0.08, 0.16},
              {HabitEffect{"deviation_rms"}, {"over_max"}, {"within_0_2", false}}},
};

}  // namespace

const MessageText& titleOf(HandLevel level) {
    switch (level) {
        case HandLevel::Expert:
            return msg::kHandExpert;
        case HandLevel::Student:
            return msg::kHandStudent;
        case HandLevel::Beginner:
            break;
    }
    return msg::kHandBeginner;
}

std::span<const HandHabit> handHabits() { return kHabits; }

HandHabits usualHabits(HandLevel level) {
    HandHabits habits;
    for (const HandHabit& each : kHabits) habits.*each.value = each.at(level);
    return habits;
}

HandHabits habitsOfHand(HandLevel level, std::uint64_t seed) {
    SeededRandom random(seed);
    HandHabits habits;
    for (const HandHabit& each : kHabits) habits.*each.value = each.at(level) * (0.85 + 0.3 * random.share());
    return habits;
}

}  // namespace tactooth

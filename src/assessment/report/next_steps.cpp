// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/next_steps.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace tactooth {
namespace {

/// Advice on a metric whose value is below or above what is ideal. {} in `low` and `high` is what was measured, and
/// where.
struct Advice {
    std::string_view metric, low, high;
};

constexpr std::array kAdvice = {
    Advice{"cleared_share", "Clear the whole marked part before you refine: {} of it is cut.", ""},
    Advice{"dice", "Keep to the marked part: the overlap with it is {}.", ""},
    Advice{"over_max", "", "Stop earlier, and look at the depth while you cut: you went {} beyond the ideal wall."},
    Advice{"over_volume", "", "Take less sound tissue: {} too much was removed."},
    Advice{"under_volume", "", "Go on until all of the marked part is cut: {} of it is left."},
    Advice{"deviation_rms", "", "Follow the ideal walls more closely: you are {} off on average."},
    Advice{"within_0_1", "Follow the ideal walls more closely: {} of the surface lies within 0.1 mm.", ""},
    Advice{"within_0_2", "Follow the ideal walls more closely: {} of the surface lies within 0.2 mm.", ""},
    Advice{"within_0_3", "Follow the ideal walls more closely: {} of the surface lies within 0.3 mm.", ""},
    Advice{"within_0_4", "Follow the ideal walls more closely: {} of the surface lies within 0.4 mm.", ""},
    Advice{"floor_depth_median", "Cut the floor deeper: it lies at {}.", "Keep the floor shallower: it lies at {}."},
    Advice{"floor_flatness", "", "Move the bur level to make the floor flat: it varies by {}."},
    Advice{"floor_tilt", "", "Hold the bur along the axis: the floor is tilted by {}."},
    Advice{"wall_angle_b", "Tilt the bur so that the buccal wall converges more toward its opening: it is at {}.",
           "Tilt the bur so that the buccal wall converges less toward its opening: it is at {}."},
    Advice{"wall_angle_l", "Tilt the bur so that the lingual wall converges more toward its opening: it is at {}.",
           "Tilt the bur so that the lingual wall converges less toward its opening: it is at {}."},
    Advice{"wall_angle_m", "Tilt the bur so that the mesial wall converges more toward its opening: it is at {}.",
           "Tilt the bur so that the mesial wall converges less toward its opening: it is at {}."},
    Advice{"wall_angle_d", "Tilt the bur so that the distal wall converges more toward its opening: it is at {}.",
           "Tilt the bur so that the distal wall converges less toward its opening: it is at {}."},
    Advice{"extent_md", "Extend the preparation to mesial and distal: it is {} long.",
           "Keep the preparation shorter from mesial to distal: it is {} long."},
    Advice{"extent_bl", "Widen the preparation to buccal and lingual: it is {} wide.",
           "Keep the preparation narrower from buccal to lingual: it is {} wide."},
    Advice{"extent_og", "Extend the preparation along the tooth: it is {} high.",
           "Keep the preparation lower along the tooth: it is {} high."},
    Advice{"toc_md", "Taper the mesial and distal walls more: they converge by {}.",
           "Hold the bur along the axis: the mesial and distal walls converge by {}."},
    Advice{"toc_bl", "Taper the buccal and lingual walls more: they converge by {}.",
           "Hold the bur along the axis: the buccal and lingual walls converge by {}."},
    Advice{"finish_line_width", "Cut the finish line wider: it is {}.", "Keep the finish line narrower: it is {}."},
    Advice{"isthmus_min", "Widen the isthmus: it is {}.", "Keep the isthmus narrower: it is {}."},
    Advice{"ridge_min_m", "Stay farther from the mesial ridge: {} is left.",
           "Go nearer to the mesial ridge: {} is left."},
    Advice{"ridge_min_d", "Stay farther from the distal ridge: {} is left.",
           "Go nearer to the distal ridge: {} is left."},
    Advice{"undercut_depth", "Undercut the wall a little: {} is there.",
           "Hold the bur upright, so that nothing hangs over: there is an undercut of {}."},
    Advice{"undercut_area", "", "Hold the bur upright, so that nothing hangs over: {} are undercut."},
    Advice{"remaining_dentin_min", "Leave more dentin over the pulp: {} is left.", ""},
    Advice{"pulp_open", "Open the pulp chamber: it is still closed.",
           "Stop before the pulp: it was opened. Look at the dentin that is left beside the tip."},
    Advice{"neighbour_depth_max", "", "Keep the bur away from the tooth beside: it was cut {} deep."},
    Advice{"unsupported_enamel", "", "Remove enamel without dentin below: there are {}."},
    Advice{"finish_line_roughness", "", "Finish the margin in one even stroke: it is {} rough."},
    Advice{"decay_left", "", "Remove all decay: {} of it is left."},
    Advice{"decay_share", "Remove all decay: {} of it is gone.", ""},
    Advice{"over_enamel", "", "Spare sound enamel: {} was removed without need."},
    Advice{"over_dentin", "", "Spare sound dentin: {} was removed without need."},
    Advice{"force_mean", "", "Press less, and let the bur cut: {} on average."},
    Advice{"force_p95", "", "Press less, and let the bur cut: often {}."},
    Advice{"force_peak", "", "Avoid hard contacts: {} at most."},
    Advice{"idle_time", "", "Let the bur turn only when it is to cut: it turned in the air for {}."},
};

std::string adviceOn(const AssessmentReport& report, const CriterionScore& each) {
    const Criterion& criterion = *each.criterion;
    const double value = *each.measured.value;
    const bool isLow = value < criterion.levels.ranges()[0].low;
    std::string measured = valueText(*criterion.metric, value);
    const std::string where = placeAndMomentText(report, each.measured);
    if (!where.empty()) measured += " (" + where + ")";
    const auto* const advice = std::ranges::find(kAdvice, criterion.metric->id, &Advice::metric);
    const std::string_view words = advice == kAdvice.end() ? std::string_view() : isLow ? advice->low : advice->high;
    if (words.empty()) {
        return fmt::format("Work on this: {}. It is {}; {} would be ideal.", criterion.title, measured,
                           isLow ? "more" : "less");
    }
    return fmt::format(fmt::runtime(words), measured);
}

}  // namespace

std::vector<std::string> nextSteps(const AssessmentReport& report) {
    constexpr std::size_t kMost = 2;
    constexpr double kLeastLoss = 1;  // points of the mark
    std::vector<const CriterionScore*> costly;
    const auto limits = [&](const CriterionScore& each) {
        return std::ranges::find(report.mark.limitedBy, each.criterion) != report.mark.limitedBy.end();
    };
    for (const CriterionScore& each : report.mark.criteria) {
        if (each.score && (each.lost >= kLeastLoss || limits(each))) costly.push_back(&each);
    }
    std::ranges::stable_sort(costly, [&](const CriterionScore* a, const CriterionScore* b) {
        if (limits(*a) != limits(*b)) return limits(*a);
        return a->lost > b->lost;
    });
    std::vector<std::string> steps;
    for (const CriterionScore* each : costly) {
        if (steps.size() < kMost) steps.push_back(adviceOn(report, *each));
    }
    if (steps.empty()) steps.emplace_back("Nothing costs a point: repeat it to be sure, or take a harder exercise.");
    return steps;
}

}  // namespace tactooth

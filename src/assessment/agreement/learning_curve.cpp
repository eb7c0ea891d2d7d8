// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/learning_curve.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "assessment/agreement/failure_detection.h"
#include "assessment/agreement/seeded_random.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr std::size_t kStudents = 50'000;  // a false alarm of 5 % is then known to 0.1 %
constexpr std::size_t kMostTrials = 1000;
constexpr std::uint64_t kPlanSeed = 5;
constexpr double kRounding = 1e-9;  // of a sum that reaches a limit exactly

bool areRates(double better, double worse) { return better > 0 && better < worse && worse < 1; }

double nextSum(const LearningPlan& plan, double sum, Trial trial) {
    return std::max(0.0, sum + (trial == Trial::Passed ? plan.passed : plan.failed));
}

/// The greatest sum of one student with this rate of failures.
double greatestSum(const LearningPlan& plan, double failureRate, SeededRandom& random) {
    double sum = 0, greatest = 0;
    for (std::size_t trial = 0; trial < plan.trials; ++trial) {
        sum = nextSum(plan, sum, random.share() < failureRate ? Trial::Failed : Trial::Passed);
        greatest = std::max(greatest, sum);
    }
    return greatest;
}

/// How many of the simulated students may reach the limit, so that we are sure of the false alarm.
std::size_t mostAlarms(double falseAlarm) {
    auto alarms = static_cast<std::size_t>(falseAlarm * static_cast<double>(kStudents));
    while (alarms > 0 && shareOf(alarms, kStudents)->interval.high > falseAlarm) --alarms;
    return alarms;
}

}  // namespace

std::size_t CusumPlan::cleanTrials() const { return static_cast<std::size_t>(std::ceil(lower / step)); }

std::optional<CusumPlan> planCusum(const CusumRates& rates) {
    const double alpha = rates.falseAlarm, beta = rates.falseTrust;
    if (!areRates(rates.acceptable, rates.unacceptable) || !(alpha > 0 && beta > 0 && alpha + beta < 1)) {
        return std::nullopt;
    }
    const double failures = std::log(rates.unacceptable / rates.acceptable);
    const double passes = std::log((1 - rates.acceptable) / (1 - rates.unacceptable));
    const double all = failures + passes;
    if (!(failures > 0 && passes > 0) || !std::isfinite(all)) return std::nullopt;
    return CusumPlan{passes / all, std::log((1 - alpha) / beta) / all, std::log((1 - beta) / alpha) / all};
}

std::vector<CusumPoint> cusumOf(const CusumPlan& plan, std::span<const Trial> trials) {
    std::vector<CusumPoint> points;
    points.reserve(trials.size());
    double sum = 0;
    for (const Trial trial : trials) {
        sum += trial == Trial::Passed ? -plan.step : 1 - plan.step;
        CusumDecision decision = CusumDecision::None;
        if (sum <= -plan.lower + kRounding) decision = CusumDecision::Acceptable;
        if (sum >= plan.upper - kRounding) decision = CusumDecision::Unacceptable;
        points.push_back({sum, decision});
        if (decision != CusumDecision::None) sum = 0;
    }
    return points;
}

std::size_t LearningPlan::cleanTrials() const { return static_cast<std::size_t>(std::ceil(limit / passed)); }

std::optional<LearningPlan> planLearning(double adequate, double inadequate, std::size_t trials, double falseAlarm) {
    if (!areRates(adequate, inadequate) || !(falseAlarm > 0 && falseAlarm < 1)) return std::nullopt;
    if (trials == 0 || trials > kMostTrials) return std::nullopt;
    LearningPlan plan{
        inadequate, std::log((1 - adequate) / (1 - inadequate)), std::log(adequate / inadequate), 0, trials,
        falseAlarm};
    if (!(plan.passed > 0) || !std::isfinite(plan.failed)) return std::nullopt;
    SeededRandom random(kPlanSeed);
    std::vector<double> greatest(kStudents);
    for (double& each : greatest) each = greatestSum(plan, inadequate, random);
    std::ranges::sort(greatest, std::greater{});
    // Those before this one may reach the limit. It lies between two sums that occur, so that rounding changes nothing.
    const double kept = greatest[mostAlarms(falseAlarm)];
    const auto above =
        std::ranges::partition_point(greatest, [&](double sum) { return sum > kept + plan.passed * 1e-9; });
    const double cleanSum = plan.passed * static_cast<double>(trials);
    const double next = above == greatest.begin() ? cleanSum : *std::prev(above);
    if (!(next > kept + plan.passed * 1e-9)) return std::nullopt;
    plan.limit = (kept + next) / 2;
    return plan;
}

LearningCurve learningCurve(const LearningPlan& plan, std::span<const Trial> trials) {
    LearningCurve curve;
    double sum = 0;
    for (const Trial trial : trials) {
        sum = nextSum(plan, sum, trial);
        if (sum >= plan.limit && !curve.learntAt) curve.learntAt = curve.sums.size();
        curve.sums.push_back(sum);
    }
    return curve;
}

double shareThatLearns(const LearningPlan& plan, double failureRate, std::uint64_t seed, std::size_t students) {
    TACTOOTH_ASSERT(students > 0);
    SeededRandom random(seed);
    std::size_t learnt = 0;
    for (std::size_t student = 0; student < students; ++student) {
        learnt += greatestSum(plan, failureRate, random) >= plan.limit ? 1 : 0;
    }
    return static_cast<double>(learnt) / static_cast<double>(students);
}

}  // namespace tactooth

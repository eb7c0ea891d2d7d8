// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tactooth {

/// One trial of a student at an exercise.
enum class Trial { Passed, Failed };

/// What a CUSUM has to distinguish: rates of failed trials, 0..1, and the risks of a wrong decision.
struct CusumRates {
    double acceptable, unacceptable;  ///< shares of failed trials, the first less than the second
    double falseAlarm = 0.1;          ///< alpha: to call an acceptable student unacceptable
    double falseTrust = 0.1;          ///< beta: to call an unacceptable student acceptable
};

/// CUSUM for proficiency: whether a student's rate of failures is acceptable or unacceptable, as soon as the trials can
/// tell (A. Wald's sequential probability ratio test; M. Bolsin and S. Colson, "The use of the Cusum technique in the
/// assessment of trainee competence in new procedures", International Journal for Quality in Health Care 12, 2000).
struct CusumPlan {
    double step;   ///< s: a passed trial lowers the sum by it, a failed one raises the sum by 1 - s
    double lower;  ///< h0: a sum of -h0 or less says acceptable
    double upper;  ///< h1: a sum of h1 or more says unacceptable

    /// Trials, all passed, until the student is called acceptable.
    [[nodiscard]] std::size_t cleanTrials() const;
};
/// Nothing unless 0 < acceptable < unacceptable < 1, both risks are over 0, and their sum is less than 1.
[[nodiscard]] std::optional<CusumPlan> planCusum(const CusumRates& rates);

enum class CusumDecision { None, Acceptable, Unacceptable };

struct CusumPoint {
    double sum;
    CusumDecision decision;
};
/// A point for each trial. After a decision the sum starts at 0 again, so that a later relapse is found.
[[nodiscard]] std::vector<CusumPoint> cusumOf(const CusumPlan& plan, std::span<const Trial> trials);

/// LC-CUSUM: whether a student has learnt an exercise, from a beginning at which nobody can do it (D. J. Biau,
/// R. Porcher, "A method for monitoring a process from an out of control to an in control state: application to the
/// learning curve", Statistics in Medicine 29, 2010). The sum rises with a passed trial, falls with a failed one, and
/// never falls below 0; a sum of `limit` or more says that the exercise has been learnt.
struct LearningPlan {
    double inadequate;      ///< rate of failures of a student who cannot do it, 0..1
    double passed, failed;  ///< steps: ln((1 - p) / (1 - inadequate)) and ln(p / inadequate), with p the adequate rate
    double limit;
    std::size_t trials;  ///< planned
    double falseAlarm;   ///< the most that `limit` was made for

    /// Trials, all passed, until the exercise counts as learnt.
    [[nodiscard]] std::size_t cleanTrials() const;
};
/// The least limit that a student with the inadequate rate reaches within the planned trials with a probability of at
/// most `falseAlarm`, by simulation of 50,000 students; 97.5 % sure. The same input gives the same bits. Nothing unless
/// 0 < adequate < inadequate < 1, 0 < falseAlarm < 1 and there are 1 to 1,000 trials; and where the trials are too few:
/// then even a student who passes all of them could be one who cannot do it.
[[nodiscard]] std::optional<LearningPlan> planLearning(double adequate, double inadequate, std::size_t trials,
                                                       double falseAlarm = 0.05);

/// The sum after each trial, and the first trial after which the exercise counts as learnt (counted from 0).
struct LearningCurve {
    std::vector<double> sums;
    std::optional<std::size_t> learntAt;
};
[[nodiscard]] LearningCurve learningCurve(const LearningPlan& plan, std::span<const Trial> trials);

/// The share of `students`, simulated, with a rate of failures of `failureRate` who reach the limit within the planned
/// trials: at the inadequate rate the false alarms, at a better one the power of the plan.
[[nodiscard]] double shareThatLearns(const LearningPlan& plan, double failureRate, std::uint64_t seed,
                                     std::size_t students = 50'000);

}  // namespace tactooth

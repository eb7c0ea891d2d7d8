// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/mark_agreement.h"

#include <cmath>
#include <vector>

namespace tactooth {
namespace {

// Halfway between the points of two levels; below the last one the mark fails.
constexpr double kLeastIdeal = 92.5;
constexpr double kLeastAcceptable = 75;
constexpr double kLeastCorrect = 65;

std::size_t levelIndex(double mark) { return static_cast<std::size_t>(levelOfMark(mark)); }

std::vector<double> differencesOf(std::span<const MarkPair> marks) {
    std::vector<double> differences;
    for (const MarkPair& each : marks) differences.push_back(each.program - each.teachers);
    return differences;
}

std::optional<double> rootMeanSquare(std::span<const double> values) {
    if (values.empty()) return std::nullopt;
    double squares = 0;
    for (const double each : values) squares += each * each;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

std::optional<double> curveOf(std::span<const MarkPair> marks, double passMark) {
    std::vector<double> passed, failed;
    for (const MarkPair& each : marks) (each.teachers < passMark ? failed : passed).push_back(each.program);
    return areaUnderCurve(passed, failed);
}

}  // namespace

Level levelOfMark(double mark) {
    if (mark >= kLeastIdeal) return Level::Ideal;
    if (mark >= kLeastAcceptable) return Level::Acceptable;
    return mark >= kLeastCorrect ? Level::Correct : Level::Fail;
}

MarkAgreement markAgreement(std::span<const MarkPair> marks, double passMark) {
    MarkAgreement agreement;
    agreement.works = marks.size();
    std::vector<double> ratings;
    std::vector<LevelPair> levels;
    std::vector<Outcome> outcomes;
    for (const MarkPair& each : marks) {
        ratings.insert(ratings.end(), {each.teachers, each.program});
        levels.push_back({levelIndex(each.teachers), levelIndex(each.program)});
        agreement.levels.add(levels.back());
        outcomes.push_back({each.teachers < passMark, each.program < passMark});
    }
    const std::vector<double> differences = differencesOf(marks);
    agreement.rms = rootMeanSquare(differences);
    agreement.icc = intraclassCorrelation(ratings, 2);
    agreement.difference = blandAltman(differences);
    agreement.linearKappa = kappaOf(levels, kMarkLevels, KappaWeights::Linear);
    agreement.quadraticKappa = kappaOf(levels, kMarkLevels, KappaWeights::Quadratic);
    agreement.failures = failureDetection(outcomes);
    agreement.areaUnderCurve = curveOf(marks, passMark);
    return agreement;
}

}  // namespace tactooth

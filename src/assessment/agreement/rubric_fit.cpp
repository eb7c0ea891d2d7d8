// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/rubric_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "assessment/agreement/range_widening.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

// Our assumptions, as standard deviations: how far a teacher's mark lies from what a rubric says, in marks, and how far
// a school's rubric lies from the start, in points of a weight and as the logarithm of a widening factor (of 1.35).
constexpr double kMarkSpread = 7;
constexpr double kWeightSpread = 10;
constexpr double kWideningSpread = 0.3;
constexpr double kWeightPenalty = (kMarkSpread * kMarkSpread) / (kWeightSpread * kWeightSpread);
constexpr double kWideningPenalty = (kMarkSpread * kMarkSpread) / (kWideningSpread * kWideningSpread);

constexpr double kAllWeights = 100;
constexpr double kSteps = 20;  // of the widening factor in 1
constexpr int kLeastStep = 10, kMostStep = 40, kStartStep = 20;
constexpr double kLeastJudged = 1e-9;  // points of weight; less is rounding
constexpr int kMostRounds = 500;
constexpr double kLeastGain = 1e-6;  // of the squared error, in a round: less ends the fit

double squared(double value) { return value * value; }

const Measured& valueOf(const FitExample& example, const PreparationMetric* metric) {
    const auto found = std::ranges::find(*example.results, metric, &MetricResult::metric);
    TACTOOTH_ASSERT(found != example.results->end());
    return found->measured;
}

/// A criterion with a weight, while it is fitted.
struct Part {
    std::size_t index;  // among the criteria of the start rubric
    double startWeight, weight;
    int step = kStartStep;
    bool mayWiden;
    std::vector<std::optional<double>> values;  // of each example
    std::vector<double> judged;                 // 1 where there is a value, else 0
    std::vector<double> scores;                 // 0 where there is no value
};

/// The fit of one rubric to its examples.
class RubricFitter {
public:
    RubricFitter(const Rubric& start, std::span<const FitExample> examples) : start_(start), examples_(examples) {
        TACTOOTH_ASSERT(!examples.empty());
        double all = 0;
        for (const Criterion& each : start.criteria) all += each.weight;
        TACTOOTH_ASSERT(all > 0);
        for (std::size_t i = 0; i < start.criteria.size(); ++i) {
            if (start.criteria[i].weight > 0) addPart(i, kAllWeights * start.criteria[i].weight / all);
        }
        for (const FitExample& each : examples) limits_.push_back(limitOf(each));
        sumUp();
    }

    void fit() {
        for (int round = 0; round < kMostRounds; ++round) {
            const double before = cost_;
            for (std::size_t a = 0; a < parts_.size(); ++a) {
                for (std::size_t b = a + 1; b < parts_.size(); ++b) moveWeight(parts_[a], parts_[b]);
            }
            for (Part& part : parts_) {
                if (part.mayWiden) chooseWidening(part);
            }
            if (before - cost_ <= kLeastGain * before) return;
        }
    }

    [[nodiscard]] RubricFit result() const;

private:
    void addPart(std::size_t index, double weight) {
        const Criterion& criterion = start_.criteria[index];
        Part part{index, weight, weight, kStartStep, !criterion.critical && !criterion.limitsMark, {}, {}, {}};
        for (const FitExample& each : examples_) {
            part.values.push_back(valueOf(each, criterion.metric).value);
            part.judged.push_back(part.values.back() ? 1 : 0);
        }
        part.scores = scoresOf(part, kStartStep);
        parts_.push_back(std::move(part));
    }

    /// The best mark that the criteria allow which limit it. Their ranges stay, and so does this.
    [[nodiscard]] double limitOf(const FitExample& example) const {
        double limit = 100;
        for (const Criterion& each : start_.criteria) {
            const std::optional<double> value = valueOf(example, each.metric).value;
            if (!value) continue;
            const double score = each.levels.scoreOf(*value);
            if (each.limitsMark) limit = std::min(limit, score);
            if (each.critical && score == 0) limit = std::min(limit, start_.criticalMark);
        }
        return limit;
    }

    [[nodiscard]] std::vector<double> scoresOf(const Part& part, int step) const {
        const LevelRanges levels = levelsOf(part, step);
        std::vector<double> scores;
        scores.reserve(part.values.size());
        for (const std::optional<double>& value : part.values) scores.push_back(value ? levels.scoreOf(*value) : 0);
        return scores;
    }
    [[nodiscard]] LevelRanges levelsOf(const Part& part, int step) const {
        return widened(start_.criteria[part.index].levels, step / kSteps);
    }

    /// Weighted sums of scores and of weights, and the cost; anew, so that the errors of many small changes do not add
    /// up.
    void sumUp() {
        scored_.assign(examples_.size(), 0);
        weighed_.assign(examples_.size(), 0);
        for (const Part& part : parts_) {
            for (std::size_t i = 0; i < examples_.size(); ++i) {
                scored_[i] += part.weight * part.scores[i];
                weighed_[i] += part.weight * part.judged[i];
            }
        }
        const auto none = [](std::size_t) { return 0.0; };
        cost_ = costAfter(none, none);
    }

    /// Mark less that of the teachers, for given sums. A work that nothing judges gets no mark, which counts as 0.
    [[nodiscard]] double errorOf(std::size_t i, double scored, double weighed) const {
        const double mark = weighed > kLeastJudged ? scored / weighed : 0;
        return std::min(mark, limits_[i]) - examples_[i].mark;
    }

    [[nodiscard]] double penalty() const {
        double sum = 0;
        for (const Part& part : parts_) {
            sum += kWeightPenalty * squared(part.weight - part.startWeight);
            sum += kWideningPenalty * squared(std::log(part.step / kSteps));
        }
        return sum;
    }

    /// The cost once the sums have changed by these amounts; weights and factors have changed already.
    template <class Change, class JudgedChange>
    [[nodiscard]] double costAfter(const Change& change, const JudgedChange& judgedChange) const {
        double sum = penalty();
        for (std::size_t i = 0; i < examples_.size(); ++i) {
            sum += squared(errorOf(i, scored_[i] + change(i), weighed_[i] + judgedChange(i)));
        }
        return sum;
    }

    /// Moves weight from one criterion to the other: a Gauss-Newton step along this line, or a shorter one.
    void moveWeight(Part& to, Part& from) {
        double move = -stepFor(to, from);
        for (int attempt = 0; attempt < 3; ++attempt, move /= 4) {
            move = std::clamp(move, -to.weight, from.weight);
            if (move == 0) return;
            const double toBefore = to.weight, fromBefore = from.weight;
            to.weight = std::max(0.0, toBefore + move);
            from.weight = std::max(0.0, fromBefore - move);
            const auto change = [&](std::size_t i) { return move * (to.scores[i] - from.scores[i]); };
            const auto judgedChange = [&](std::size_t i) { return move * (to.judged[i] - from.judged[i]); };
            if (costAfter(change, judgedChange) < cost_) return sumUp();
            to.weight = toBefore;
            from.weight = fromBefore;
        }
    }

    /// Half the slope of the cost over half its curvature, for weight that moves from one criterion to the other.
    [[nodiscard]] double stepFor(const Part& to, const Part& from) const {
        double slope = kWeightPenalty * ((to.weight - to.startWeight) - (from.weight - from.startWeight));
        double curvature = 2 * kWeightPenalty;
        for (std::size_t i = 0; i < examples_.size(); ++i) {
            if (weighed_[i] <= kLeastJudged) continue;
            const double mark = scored_[i] / weighed_[i];
            if (mark > limits_[i]) continue;
            const double rise =
                ((to.scores[i] - from.scores[i]) - mark * (to.judged[i] - from.judged[i])) / weighed_[i];
            slope += rise * (mark - examples_[i].mark);
            curvature += rise * rise;
        }
        return slope / curvature;
    }

    /// Tries all widening factors, and keeps the best.
    void chooseWidening(Part& part) {
        const std::vector<double> before = part.scores;
        std::vector<double> bestScores = before;
        int best = part.step;
        double bestCost = cost_;
        for (int step = kLeastStep; step <= kMostStep; ++step) {
            part.step = step;
            part.scores = scoresOf(part, step);
            const auto change = [&](std::size_t i) { return part.weight * (part.scores[i] - before[i]); };
            const double now = costAfter(change, [](std::size_t) { return 0.0; });
            if (now >= bestCost) continue;
            bestCost = now;
            best = step;
            bestScores = part.scores;
        }
        part.step = best;
        part.scores = std::move(bestScores);
        if (bestCost < cost_) sumUp();
    }

    const Rubric& start_;
    std::span<const FitExample> examples_;
    std::vector<Part> parts_;
    std::vector<double> limits_;            // of each example
    std::vector<double> scored_, weighed_;  // of each example: see sumUp
    double cost_ = 0;
};

/// Weights in tenths that sum up to 100: rounded down, and a tenth more for those that lose most by that.
std::vector<double> inTenths(const std::vector<double>& weights) {
    std::vector<long> tenths;
    std::vector<std::size_t> order;
    long missing = static_cast<long>(10 * kAllWeights);
    for (const double each : weights) {
        order.push_back(tenths.size());
        tenths.push_back(static_cast<long>(10 * each));
        missing -= tenths.back();
    }
    const auto lost = [&](std::size_t i) { return 10 * weights[i] - static_cast<double>(tenths[i]); };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return lost(a) > lost(b); });
    for (std::size_t i = 0; missing > 0; i = (i + 1) % order.size(), --missing) ++tenths[order[i]];
    std::vector<double> rounded;
    rounded.reserve(tenths.size());
    for (const long each : tenths) rounded.push_back(static_cast<double>(each) / 10);
    return rounded;
}

RubricFit RubricFitter::result() const {
    RubricFit fit{{start_.name, start_.passMark, start_.criticalMark, {}}, {}};
    for (const Criterion& each : start_.criteria) fit.criteria.push_back({&each, 0, 1});
    std::vector<double> weights;
    for (const Part& part : parts_) weights.push_back(part.weight);
    const std::vector<double> tenths = inTenths(weights);
    std::vector<LevelRanges> levels;
    for (const Criterion& each : start_.criteria) levels.push_back(each.levels);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        fit.criteria[part.index].weight = tenths[i];
        fit.criteria[part.index].widening = part.step / kSteps;
        levels[part.index] = levelsOf(part, part.step);
    }
    for (std::size_t i = 0; i < start_.criteria.size(); ++i) {
        Criterion criterion = start_.criteria[i];
        criterion.weight = fit.criteria[i].weight;
        criterion.levels = levels[i];
        if (criterion.weight > 0 || criterion.critical || criterion.limitsMark)
            fit.rubric.criteria.push_back(criterion);
    }
    return fit;
}

}  // namespace

RubricFit fitRubric(const Rubric& start, std::span<const FitExample> examples) {
    RubricFitter fitter(start, examples);
    fitter.fit();
    return fitter.result();
}

}  // namespace tactooth

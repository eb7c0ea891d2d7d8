// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "assessment/rubric/rubric.h"

namespace tactooth {

/// A measured work, and the mark that a rubric should give it.
struct FitExample {
    const std::vector<MetricResult>* results;  ///< not null; with each metric of the rubric
    double mark;                               ///< 0..100
};

/// What a fit makes of one criterion.
struct CriterionFit {
    const Criterion* start;  ///< in the rubric that the fit began with
    double weight;           ///< of 100, in tenths; 0 stays 0
    double widening;         ///< of the ranges, 0.5 to 2 in steps of 0.05; more than 1 is more generous
};

/// A fitted rubric. A criterion whose weight has become 0 is left out, unless it limits the mark.
struct RubricFit {
    Rubric rubric;
    std::vector<CriterionFit> criteria;  ///< one for each of the start rubric, in its order
};

/// The weights and widening factors for which the marks of `start` come closest to those of the examples, by least
/// squares. A penalty holds each at its start unless the marks say otherwise: with a dozen criteria and some tens of
/// works the marks alone do not determine them (A. E. Hoerl, R. W. Kennard, "Ridge regression", Technometrics 12,
/// 1970).
///
/// Pass mark, critical mark, and what is critical or limits the mark stay as they are; the ranges of such criteria do,
/// too, so that an error stays an error. Criteria without a weight get none.
///
/// By coordinate descent, so it may be a local optimum; takes about 0.1 s for 100 works. The same input gives the same
/// bits. There is one example at least. `start` outlives the result.
[[nodiscard]] RubricFit fitRubric(const Rubric& start, std::span<const FitExample> examples);

}  // namespace tactooth

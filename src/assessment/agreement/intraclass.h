// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "assessment/agreement/interval.h"

namespace tactooth {

/// How far raters agree who have all rated the same works: two-way analysis of variance, and the intraclass
/// correlations of P. E. Shrout and J. L. Fleiss ("Intraclass correlations: uses in assessing rater reliability",
/// Psychological Bulletin 86, 1979). 1: they agree in all; 0 or less: their ratings say nothing about the work. Each
/// correlation is nothing where its denominator is not positive, as for ratings that are all equal.
struct IntraclassCorrelation {
    std::size_t works, raters;

    /// Mean squares, in squared units of the rating: between works, between raters, within works, and what the two-way
    /// model leaves.
    double betweenWorks, betweenRaters, withinWorks, residual;

    /// Of one rating. `oneWay` is ICC(1,1). `agreement` is ICC(2,1), the one to report: a rater who is stricter than
    /// the others disagrees. `consistency` is ICC(3,1): only the order and the distances of the works count.
    std::optional<double> oneWay, agreement, consistency;
    /// Of the mean of all raters: ICC(2,k) and ICC(3,k).
    std::optional<double> meanAgreement, meanConsistency;

    /// Of `agreement`, by F quantiles with Satterthwaite's degrees of freedom (K. O. McGraw, S. P. Wong, "Forming
    /// inferences about some intraclass correlation coefficients", Psychological Methods 1, 1996, table 7). A bootstrap
    /// over works is too narrow for the five to twenty works of a usual class, and cannot vary the raters. Nothing
    /// where all agree exactly.
    std::optional<Interval> agreementInterval;
};

/// `ratings`: a row for each work, in it one finite rating for each rater. Nothing for fewer than two works or raters.
[[nodiscard]] std::optional<IntraclassCorrelation> intraclassCorrelation(std::span<const double> ratings,
                                                                         std::size_t raters);

}  // namespace tactooth

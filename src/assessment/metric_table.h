// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "assessment/cavity_metrics.h"
#include "geometry/util/message.h"

namespace tactooth {

enum class Better { Neither, Higher, Lower };

/// One metric of a cavity: a row of the table from which the score command, the report, the exercise panel and the page
/// docs/user/metrics.md (metrics.ja.md) are rendered. A new metric is a new row.
struct Metric {
    std::string_view key;       ///< in JSON; stable
    std::string_view quantity;  ///< in tables and in the CSV report; stable
    std::string_view unit;      ///< of `compute`: "mm^3" or "mm"; empty: a fraction 0..1, shown as %
    Better better;
    double (*compute)(const CavityProgress& cavity);
    /// For the documentation, with the source if it has one.
    std::string_view definition, definitionJa;
    /// Of the row in the exercise panel, in the two languages of the window; no title: it has no row there.
    std::string_view titleEn = {}, titleJa = {}, tipEn = {}, tipJa = {};

    [[nodiscard]] std::string_view definitionIn(Language language) const {
        return language == Language::English ? definition : definitionJa;
    }
    [[nodiscard]] bool isFraction() const { return unit.empty(); }
    /// The value in the unit that people read: a fraction in %.
    [[nodiscard]] double shown(const CavityProgress& cavity) const;
    [[nodiscard]] std::string_view shownUnit() const { return isFraction() ? "%" : unit; }
};

/// In the order of the report.
[[nodiscard]] std::span<const Metric> metricTable();

/// The page docs/user/metrics.md, or metrics.ja.md.
[[nodiscard]] std::string metricsPage(Language language);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/metric_table.h"

#include <array>

#include "assessment/preparation/preparation_metrics.h"

namespace tactooth {
namespace {

constexpr double kPercent = 100;
constexpr std::array<std::string_view, 3> kBetterWords = {"-", "higher", "lower"};  // as Better

constexpr std::array kMetrics = {
    Metric{"ideal_mm3", "ideal cavity", "mm^3", Better::Neither, [](const CavityProgress& c) { return c.planned; },
           "Volume of the ideal cavity."},
    Metric{"cleared_mm3", "of it cut", "mm^3", Better::Higher, [](const CavityProgress& c) { return c.cleared; },
           "Volume that was cut inside the ideal cavity."},
    Metric{"cleared_share", "of it cut", "", Better::Higher,
           [](const CavityProgress& c) { return c.clearedFraction(); }, "Cut share of the volume of the ideal cavity."},
    Metric{"beyond_mm3", "cut beyond it", "mm^3", Better::Lower, [](const CavityProgress& c) { return c.beyond; },
           "Over-preparation: volume that was cut outside the ideal cavity.", "Over-preparation", "削りすぎの体積",
           "Volume that was cut outside the ideal cavity", "理想窩洞の外で削った体積"},
    Metric{"deepest_beyond_mm", "deepest beyond it", "mm", Better::Lower,
           [](const CavityProgress& c) { return c.maxOverPreparation; },
           "Maximum over-preparation depth: greatest distance of the cut surface beyond the ideal walls.",
           "Maximum depth of it", "削りすぎの最大深さ", "Greatest distance of the cut beyond the ideal walls",
           "理想の壁を越えて削った深さの最大値"},
    Metric{"likeness", "likeness", "", Better::Higher, [](const CavityProgress& c) { return c.dice(); },
           "Dice coefficient of the cavity and the ideal one: twice the common volume over the sum of both volumes "
           "(Dice 1945).",
           "Overlap (Dice)", "一致度 (Dice 係数)",
           "Dice coefficient: twice the common volume of your cavity and the ideal one over the sum of both. 100 % is "
           "the ideal cavity",
           "Dice 係数: あなたの窩洞と理想窩洞の共通体積の 2 倍を両者の和で割った値。100 % は理想窩洞です"},
};

std::string preparationTable() {
    std::string table =
        "\n## Of a finished preparation\n\n`tactooth assess` measures these, and a rubric makes a mark of them "
        "([assessment](../assessment.md)).\n\n| id | in reports | unit | better | definition "
        "|\n|---|---|---|---|---|\n";
    for (const PreparationMetric& metric : preparationMetrics()) {
        table.append("| `").append(metric.id).append("` | ").append(metric.title).append(" | ").append(metric.unit);
        table.append(" | ").append(kBetterWords[static_cast<std::size_t>(metric.better)]).append(" | ");
        table.append(metric.definition).append(" |\n");
    }
    return table;
}

}  // namespace

double Metric::shown(const CavityProgress& cavity) const { return (isFraction() ? kPercent : 1) * compute(cavity); }

std::span<const Metric> metricTable() { return kMetrics; }

std::string metricsPage() {
    std::string page =
        "# Metrics of a cavity\n\nThis page is made by `tactooth manual metrics` from the metric table; do not edit "
        "it. `tactooth score`\ncomputes the metrics, the report of the window lists them, and the exercise panel shows "
        "the main ones.\n\n| JSON key | in tables | unit | better | definition |\n|---|---|---|---|---|\n";
    for (const Metric& metric : metricTable()) {
        page.append("| `").append(metric.key).append("` | ").append(metric.quantity).append(" | ");
        page.append(metric.isFraction() ? "fraction, % in tables" : metric.unit).append(" | ");
        page.append(kBetterWords[static_cast<std::size_t>(metric.better)]).append(" | ").append(metric.definition);
        page.append(" |\n");
    }
    page += preparationTable();
    return page;
}

}  // namespace tactooth

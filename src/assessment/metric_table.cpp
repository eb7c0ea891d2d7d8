// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/metric_table.h"

#include <array>
#include <initializer_list>

#include "assessment/preparation/preparation_metrics.h"

namespace tactooth {
namespace {

constexpr double kPercent = 100;

/// The words of the page of metrics in one language.
struct PageWords {
    std::string_view head;                   // up to the first row of the first table
    std::string_view preparation;            // the same of the second table
    std::string_view fraction;               // in place of a unit
    std::array<std::string_view, 3> better;  // as Better
};

constexpr PageWords kEnglishPage{
    "# Metrics of a cavity\n\nThis page is made by `tactooth manual metrics` from the metric table; do not edit it. "
    "`tactooth score`\ncomputes the metrics, the report of the window lists them, and the exercise panel shows the "
    "main ones.\n\n| JSON key | in tables | unit | better | definition |\n|---|---|---|---|---|\n",
    "\n## Of a finished preparation\n\n`tactooth assess` measures these, and a rubric makes a mark of them "
    "([assessment](../assessment.md)).\n\n| id | in reports | unit | better | definition |\n|---|---|---|---|---|\n",
    "fraction, % in tables",
    {"-", "higher", "lower"}};

constexpr PageWords kJapanesePage{
    "# 窩洞の計測値\n\nこのページは `tactooth manual metrics-ja` が計測値の表から作ります。直接編集しないでください。"
    "`tactooth score` がこれらを計算し、ウィンドウの報告書に並び、主なものは課題のパネルに出ます。\n\n"
    "| JSON のキー | 表での名前 | 単位 | 良い向き | 定義 |\n|---|---|---|---|---|\n",
    "\n## 仕上がった形成の計測値\n\n`tactooth assess` がこれらを計測し、評価基準表に従って評点を出します"
    "（[評価](../assessment.ja.md)）。\n\n| id | 報告書での名前 | 単位 | 良い向き | 定義 |\n|---|---|---|---|---|\n",
    "割合（表では %）",
    {"-", "大きいほど良い", "小さいほど良い"}};

const PageWords& pageWords(Language language) { return language == Language::English ? kEnglishPage : kJapanesePage; }

constexpr std::array kMetrics = {
    Metric{"ideal_mm3", "ideal cavity", "mm^3", Better::Neither, [](const CavityProgress& c) { return c.planned; },
           "Volume of the ideal cavity.", "理想窩洞の体積。"},
    Metric{"cleared_mm3", "of it cut", "mm^3", Better::Higher, [](const CavityProgress& c) { return c.cleared; },
           "Volume that was cut inside the ideal cavity.", "理想窩洞の中で削った体積。"},
    Metric{"cleared_share", "of it cut", "", Better::Higher,
           [](const CavityProgress& c) { return c.clearedFraction(); }, "Cut share of the volume of the ideal cavity.",
           "理想窩洞の体積のうち、削った割合。"},
    Metric{"beyond_mm3", "cut beyond it", "mm^3", Better::Lower, [](const CavityProgress& c) { return c.beyond; },
           "Over-preparation: volume that was cut outside the ideal cavity.", "削りすぎ：理想窩洞の外で削った体積。",
           "Over-preparation", "削りすぎの体積", "Volume that was cut outside the ideal cavity",
           "理想窩洞の外で削った体積"},
    Metric{"deepest_beyond_mm", "deepest beyond it", "mm", Better::Lower,
           [](const CavityProgress& c) { return c.maxOverPreparation; },
           "Maximum over-preparation depth: greatest distance of the cut surface beyond the ideal walls.",
           "削りすぎの最大深さ：削った面が理想の壁を越えた距離の最大値。", "Maximum depth of it", "削りすぎの最大深さ",
           "Greatest distance of the cut beyond the ideal walls", "理想の壁を越えて削った深さの最大値"},
    Metric{"likeness", "likeness", "", Better::Higher, [](const CavityProgress& c) { return c.dice(); },
           "Dice coefficient of the cavity and the ideal one: twice the common volume over the sum of both volumes "
           "(Dice 1945).",
           "窩洞と理想窩洞の Dice 係数：共通体積の 2 倍を、両者の和で割った値（Dice 1945）。", "Overlap (Dice)",
           "一致度 (Dice 係数)",
           "Dice coefficient: twice the common volume of your cavity and the ideal one over the sum of both. 100 % is "
           "the ideal cavity",
           "Dice 係数: あなたの窩洞と理想窩洞の共通体積の 2 倍を両者の和で割った値。100 % は理想窩洞です"},
};

void addRow(std::string& page, std::initializer_list<std::string_view> cells) {
    for (const std::string_view cell : cells) page.append("| ").append(cell).append(" ");
    page.append("|\n");
}

std::string inCode(std::string_view name) { return '`' + std::string(name) + '`'; }

}  // namespace

double Metric::shown(const CavityProgress& cavity) const { return (isFraction() ? kPercent : 1) * compute(cavity); }

std::span<const Metric> metricTable() { return kMetrics; }

std::string metricsPage(Language language) {
    const PageWords& words = pageWords(language);
    const auto better = [&](Better which) { return words.better[static_cast<std::size_t>(which)]; };
    std::string page(words.head);
    for (const Metric& metric : metricTable()) {
        addRow(page, {inCode(metric.key), metric.quantity, metric.isFraction() ? words.fraction : metric.unit,
                      better(metric.better), metric.definitionIn(language)});
    }
    page.append(words.preparation);
    for (const PreparationMetric& metric : preparationMetrics()) {
        addRow(page, {inCode(metric.id), metric.titleIn(language), metric.unit, better(metric.better),
                      metric.definitionIn(language)});
    }
    return page;
}

}  // namespace tactooth

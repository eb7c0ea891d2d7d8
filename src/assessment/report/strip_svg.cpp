// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/strip_svg.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "assessment/report/assessment_report.h"
#include "assessment/report/messages.h"
#include "assessment/report/svg_text.h"

namespace tactooth {
namespace {

constexpr double kLeastForce = 1, kLeastDepth = 1;             // N, mm: the least ends of the scales
constexpr double kLeft = 12, kBottom = 5, kTop = 4, kGap = 3;  // mm around the two plots and between them

/// A step of 1, 2 or 5 times a power of ten that divides `range` into six parts at most.
double niceStep(double range) {
    const double power = std::pow(10, std::floor(std::log10(range)));
    for (const double factor : {0.2, 0.5, 1.0, 2.0}) {
        if (range <= 6 * factor * power) return factor * power;
    }
    return 5 * power;
}

/// A step in s that people read as time.
double timeStep(double seconds) {
    for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0}) {
        if (seconds <= 12 * step) return step;
    }
    return 1800;
}

/// One of the two curves, in a box on paper.
struct Plot {
    double left, right, top, bottom;  // mm
    double most;                      // value at the far end of the scale
    bool isDownward;                  // 0 is at the top
    std::string_view colour, title;

    [[nodiscard]] double at(double value) const {
        const double share = std::clamp(value / most, 0.0, 1.0);
        return isDownward ? top + share * (bottom - top) : bottom - share * (bottom - top);
    }
    [[nodiscard]] std::string drawn(const std::vector<WorkStrip::Column>& columns,
                                    double WorkStrip::Column::*value) const {
        std::string svg;
        for (double tick = 0, step = niceStep(most); tick <= most * 1.0001; tick += step) {
            svg += svgLine(left, at(tick), right, at(tick), "stroke=\"#e3e8ec\" stroke-width=\"0.2\"");
            svg += svgText(left - 1, at(tick) + 0.8, "end", fmt::format("{:g}", std::round(tick * 1e3) / 1e3));
        }
        std::string path = fmt::format("M{:.2f} {:.2f}", left, at(0));
        const double step = (right - left) / static_cast<double>(columns.size());
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const double x = left + static_cast<double>(i) * step, y = at(columns[i].*value);
            path += fmt::format("L{:.2f} {:.2f}L{:.2f} {:.2f}", x, y, x + step, y);
        }
        path += fmt::format("L{:.2f} {:.2f}Z", right, at(0));
        svg += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"none\"/>\n", path, colour);
        const double middle = (top + bottom) / 2;
        svg += fmt::format(
            "<text transform=\"translate(2.6 {:.2f}) rotate(-90)\" text-anchor=\"middle\" "
            "fill=\"#55636f\" font-size=\"2.4\">{}</text>\n",
            middle, title);
        return svg;
    }
};

double mostOf(const std::vector<WorkStrip::Column>& columns, double WorkStrip::Column::*value, double least) {
    double most = least;
    for (const WorkStrip::Column& each : columns) most = std::max(most, each.*value);
    return most;
}

}  // namespace

std::string stripSvg(const WorkStrip& strip, double width, double height, Language language) {
    std::string svg = svgHead(width, height);
    const double right = width - 2, each = (height - kTop - kBottom - kGap) / 2;
    const Plot force{.left = kLeft,
                     .right = right,
                     .top = kTop,
                     .bottom = kTop + each,
                     .most = mostOf(strip.columns, &WorkStrip::Column::force, kLeastForce),
                     .isDownward = false,
                     .colour = "#5d83a8",
                     .title = msg::kStripForce.in(language)};
    const Plot depth{.left = kLeft,
                     .right = right,
                     .top = kTop + each + kGap,
                     .bottom = height - kBottom,
                     .most = mostOf(strip.columns, &WorkStrip::Column::depth, kLeastDepth),
                     .isDownward = true,
                     .colour = "#b79a63",
                     .title = msg::kStripDepth.in(language)};
    svg += force.drawn(strip.columns, &WorkStrip::Column::force);
    svg += depth.drawn(strip.columns, &WorkStrip::Column::depth);
    const auto xOf = [&](double time) { return kLeft + (right - kLeft) * std::clamp(time / strip.seconds, 0.0, 1.0); };
    if (strip.seconds > 0) {
        for (double time = 0, step = timeStep(strip.seconds); time <= strip.seconds; time += step) {
            svg += svgText(xOf(time), height - 1.2, "middle", momentText(time));
        }
        double free = 0;  // where the next number has room
        for (std::size_t i = 0; i < strip.marks.size(); ++i) {
            const std::string_view colour = strip.marks[i].isError ? "#b23a24" : "#2f7d4f";
            const double x = xOf(strip.marks[i].time);
            svg += svgLine(x, kTop, x, height - kBottom, fmt::format("stroke=\"{}\" stroke-width=\"0.25\"", colour));
            const double at = std::max(x, free);
            svg += svgText(at, kTop - 1, "middle", fmt::format("{}", i + 1), colour);
            free = at + 3;
        }
    }
    return svg + "</svg>\n";
}

}  // namespace tactooth

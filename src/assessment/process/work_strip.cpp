// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/work_strip.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr std::size_t kDepthsPerColumn = 2;
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

std::string clock(double seconds) {
    const auto whole = static_cast<long>(std::lround(seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
    return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", x1, y1, x2, y2, style);
}

std::string text(double x, double y, std::string_view anchor, std::string_view words,
                 std::string_view colour = "#55636f") {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\" fill=\"{}\" font-size=\"2.4\">{}</text>\n",
                       x, y, anchor, colour, words);
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
            svg += line(left, at(tick), right, at(tick), "stroke=\"#e3e8ec\" stroke-width=\"0.2\"");
            svg += text(left - 1, at(tick) + 0.8, "end", fmt::format("{:g}", std::round(tick * 1e3) / 1e3));
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

WorkStrip workStrip(const SessionTrack& track, const SurfacePart& original, std::size_t columns,
                    std::size_t mostMarks) {
    TACTOOTH_ASSERT(columns > 0);
    WorkStrip strip{.seconds = track.seconds()};
    strip.columns.resize(columns);
    if (!(strip.seconds > 0)) return strip;
    const double perColumn = strip.seconds / static_cast<double>(columns);
    std::vector<Vec3> tips(columns * kDepthsPerColumn, Vec3::Constant(1e6));  // the last one of each part of a column
    track.forEachTick(0, track.ticks(), [&](const TrackTick& tick) {
        const double at = tick.time / perColumn;
        const auto column = std::min(columns - 1, static_cast<std::size_t>(std::max(0.0, at)));
        const double force = std::hypot(tick.force[0], tick.force[1], tick.force[2]);
        if (tick.contacts > 0) strip.columns[column].force = std::max(strip.columns[column].force, force);
        const auto part = static_cast<std::size_t>(std::max(0.0, at * kDepthsPerColumn));
        if (tick.placed) {
            tips[std::min(tips.size() - 1, part)] = {tick.position[0], tick.position[1], tick.position[2]};
        }
    });
    constexpr std::size_t kGrain = 16;
    constexpr double kFar = 1e5;  // mm: no tip was there
    std::vector<double> depths(tips.size());
    parallelFor(
        tips.size(),
        [&](std::size_t i) {
            if (tips[i].x() < kFar) depths[i] = std::max(0.0, -signedDistance(original, tips[i]));
        },
        kGrain);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        double& depth = strip.columns[i / kDepthsPerColumn].depth;
        depth = std::max(depth, depths[i]);
    }
    std::set<std::string_view> kinds;
    for (const TrackEvent& event : track.events()) {
        if (strip.marks.size() == mostMarks) break;
        if (kinds.insert(event.text->id).second) strip.marks.push_back({event.time, std::string(event.text->english)});
    }
    return strip;
}

std::string stripSvg(const WorkStrip& strip, double width, double height) {
    std::string svg = fmt::format(
        "<svg width=\"{0:.1f}mm\" height=\"{1:.1f}mm\" viewBox=\"0 0 {0:.1f} "
        "{1:.1f}\" font-family=\"Noto Sans, Arial, sans-serif\" font-weight=\"normal\">\n",
        width, height);
    const double right = width - 2, each = (height - kTop - kBottom - kGap) / 2;
    const Plot force{.left = kLeft,
                     .right = right,
                     .top = kTop,
                     .bottom = kTop + each,
                     .most = mostOf(strip.columns, &WorkStrip::Column::force, kLeastForce),
                     .isDownward = false,
                     .colour = "#5d83a8",
                     .title = "force, N"};
    const Plot depth{.left = kLeft,
                     .right = right,
                     .top = kTop + each + kGap,
                     .bottom = height - kBottom,
                     .most = mostOf(strip.columns, &WorkStrip::Column::depth, kLeastDepth),
                     .isDownward = true,
                     .colour = "#b79a63",
                     .title = "depth, mm"};
    svg += force.drawn(strip.columns, &WorkStrip::Column::force);
    svg += depth.drawn(strip.columns, &WorkStrip::Column::depth);
    const auto xOf = [&](double time) { return kLeft + (right - kLeft) * std::clamp(time / strip.seconds, 0.0, 1.0); };
    if (strip.seconds > 0) {
        for (double time = 0, step = timeStep(strip.seconds); time <= strip.seconds; time += step) {
            svg += text(xOf(time), height - 1.2, "middle", clock(time));
        }
        double free = 0;  // where the next number has room
        for (std::size_t i = 0; i < strip.marks.size(); ++i) {
            const std::string_view colour = strip.marks[i].isError ? "#b23a24" : "#2f7d4f";
            const double x = xOf(strip.marks[i].time);
            svg += line(x, kTop, x, height - kBottom, fmt::format("stroke=\"{}\" stroke-width=\"0.25\"", colour));
            const double at = std::max(x, free);
            svg += text(at, kTop - 1, "middle", fmt::format("{}", i + 1), colour);
            free = at + 3;
        }
    }
    return svg + "</svg>\n";
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/margin_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "assessment/messages.h"
#include "assessment/preparation/cut_patch.h"
#include "collision/bvh/closest_point.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kStep = 0.05;       // mm between two points of a line
constexpr double kSmooth = 0.5;      // mm: standard deviation of the smoothing
constexpr double kShortest = 2;      // mm: a shorter line runs round a chip or a hole
constexpr double kWallCosine = 0.5;  // of normal and axis: an axial wall leans 30 degrees at most

using Line = std::vector<Vec3>;  // closed

/// The closed lines of the rim, laid on the uncut surface.
std::vector<Line> closedLines(const CutSurfaces& surfaces, const SurfacePart& original) {
    std::multimap<std::uint32_t, std::uint32_t> next;
    for (const auto& [from, to] : surfaces.cut.rim) next.emplace(from, to);
    std::vector<Line> lines;
    while (!next.empty()) {
        const std::uint32_t first = next.begin()->first;
        Line line;
        std::uint32_t at = first;
        for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
            const Vec3 place = surfaces.cut.mesh.vertices[at].cast<double>();
            const auto outside = closestPoint(original, place, 4 * kCavityDepth);
            line.push_back(outside ? outside->point : place);
            at = found->second;
            next.erase(found);
        }
        if (at == first) lines.push_back(std::move(line));
    }
    return lines;
}

double lengthOf(const Line& line) {
    double length = 0;
    for (std::size_t i = 0; i < line.size(); ++i) length += (line[(i + 1) % line.size()] - line[i]).norm();
    return length;
}

/// Points at equal distances of about kStep.
Line evenly(const Line& line) {
    const double length = lengthOf(line);
    const auto count = static_cast<std::size_t>(std::ceil(length / kStep));
    Line even;
    std::size_t at = 0;
    double begin = 0;  // of the piece that starts at `at`
    for (std::size_t i = 0; i < count; ++i) {
        const double along = length * static_cast<double>(i) / static_cast<double>(count);
        double piece = (line[(at + 1) % line.size()] - line[at]).norm();
        while (begin + piece < along && at + 1 < line.size()) {
            begin += piece;
            ++at;
            piece = (line[(at + 1) % line.size()] - line[at]).norm();
        }
        const double share = piece > 0 ? (along - begin) / piece : 0;
        even.push_back(line[at] + share * (line[(at + 1) % line.size()] - line[at]));
    }
    return even;
}

/// The mean of the neighbours along the line by a Gaussian curve. `step`: mm between two points.
Line smoothed(const Line& line, double step) {
    const auto reach = std::min(line.size() / 2, static_cast<std::size_t>(std::ceil(3 * kSmooth / step)));
    std::vector<double> weights;
    double sum = 0;
    for (std::size_t k = 0; k <= reach; ++k) {
        const double distance = static_cast<double>(k) * step / kSmooth;
        weights.push_back(std::exp(-distance * distance / 2));
        sum += (k == 0 ? 1 : 2) * weights.back();
    }
    Line result;
    for (std::size_t i = 0; i < line.size(); ++i) {
        Vec3 mean = weights[0] / sum * line[i];
        for (std::size_t k = 1; k <= reach; ++k) {
            mean += weights[k] / sum * (line[(i + k) % line.size()] + line[(i + line.size() - k) % line.size()]);
        }
        result.push_back(mean);
    }
    return result;
}

/// How far each point lies from the smooth line. Smoothing draws a round line inwards, so what it has taken away is
/// smoothed and put back: a circle of 1.5 mm is then right to 0.005 mm.
std::vector<double> offSmooth(const Line& line) {
    const double step = lengthOf(line) / static_cast<double>(line.size());
    const Line once = smoothed(line, step), twice = smoothed(once, step);
    std::vector<double> off;
    for (std::size_t i = 0; i < line.size(); ++i) off.push_back((line[i] - (2 * once[i] - twice[i])).norm());
    return off;
}

Measured roughnessOf(const std::vector<Line>& lines) {
    double squares = 0, greatest = -1;
    std::size_t count = 0;
    Vec3 place = Vec3::Zero();
    for (const Line& line : lines) {
        const std::vector<double> off = offSmooth(line);
        count += off.size();
        for (std::size_t i = 0; i < off.size(); ++i) {
            squares += off[i] * off[i];
            if (off[i] <= greatest) continue;
            greatest = off[i];
            place = line[i];
        }
    }
    return Measured::at(std::sqrt(squares / static_cast<double>(count)), place);
}

/// The part of the cut surface that is an axial wall; null where there is none.
std::shared_ptr<const SurfacePart> axialWall(const Preparation& preparation, const CutSurfaces& surfaces) {
    const CutPatch patch = patchBetween(surfaces, preparation.axis, -kWallCosine, kWallCosine);
    if (patch.empty()) return nullptr;
    TriangleMesh wall{surfaces.cut.mesh.vertices, {}};
    for (const std::uint32_t i : patch) wall.triangles.push_back(surfaces.cut.mesh.triangles[i]);
    return std::make_shared<const SurfacePart>(std::move(wall));
}

/// Height along the axis of the gum beside a place of the margin; nothing where there is none.
std::optional<double> gumBeside(const Preparation& preparation, const Vec3& place) {
    constexpr double kOver = 6;                        // mm above the place: below the other jaw
    constexpr double kNearest = 0.1, kFarthest = 1.0;  // mm beside the tooth, within which the gum's margin stands
    constexpr int kAside = 10;                         // places between these two
    const auto outside = closestPoint(*preparation.original, place);
    const Vec3 normal = preparation.original->mesh().areaVector(outside->triangle).stableNormalized();
    const Vec3 level = normal - normal.dot(preparation.axis) * preparation.axis;
    if (level.norm() < kWallCosine) return std::nullopt;
    std::optional<double> highest;
    for (const auto& gum : preparation.gums) {
        const Surface surface{.base = gum};
        for (int i = 0; i < kAside; ++i) {
            const double aside = kNearest + (kFarthest - kNearest) * i / (kAside - 1);
            const Vec3 from = place + kOver * preparation.axis + aside * level.normalized();
            const auto hit = firstHit(surface, {from, -preparation.axis});
            if (!hit) continue;
            const double height = from.dot(preparation.axis) - *hit;
            highest = std::max(highest.value_or(height), height);
        }
    }
    return highest;
}

Measured heightAboveGum(const Preparation& preparation, const std::vector<Line>& lines) {
    if (preparation.gums.empty()) return Measured::none(msg::kNoGumKnown);
    std::vector<double> heights;
    for (const Line& line : lines) {
        for (const Vec3& place : line) {
            const auto gum = gumBeside(preparation, place);
            if (gum) heights.push_back(place.dot(preparation.axis) - *gum);
        }
    }
    if (heights.empty()) return Measured::none(msg::kNoGumKnown);
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    return Measured::of(*middle);
}

}  // namespace

MarginLine marginLine(const Preparation& preparation, const CutSurfaces& surfaces) {
    MarginLine result;
    std::vector<Line> lines;
    for (const Line& line : closedLines(surfaces, *preparation.original)) {
        if (lengthOf(line) > kShortest) lines.push_back(evenly(line));
    }
    if (lines.empty()) {
        result.roughness = result.width = result.widthSpread = result.heightAboveGum =
            Measured::none(msg::kNoMarginLine);
        return result;
    }
    result.roughness = roughnessOf(lines);
    const auto wall = surfaces.isCrown ? axialWall(preparation, surfaces) : nullptr;
    if (wall == nullptr) {
        result.width = result.widthSpread = result.heightAboveGum = Measured::none(msg::kNoCrownPreparation);
        return result;
    }
    result.heightAboveGum = heightAboveGum(preparation, lines);
    std::vector<double> widths;
    double sum = 0, squares = 0;
    for (const Line& line : lines) {
        for (const Vec3& place : line) {
            const Vec3 across = closestPoint(*wall, place)->point - place;
            widths.push_back((across - across.dot(preparation.axis) * preparation.axis).norm());
            sum += widths.back();
            squares += widths.back() * widths.back();
        }
    }
    const auto count = static_cast<double>(widths.size());
    const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
    std::nth_element(widths.begin(), middle, widths.end());
    result.width = Measured::of(*middle);
    result.widthSpread = Measured::of(std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count))));
    return result;
}

}  // namespace tactooth

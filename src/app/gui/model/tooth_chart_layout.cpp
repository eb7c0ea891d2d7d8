// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/tooth_chart_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"
#include "instruments/builtin_tooth.h"
#include "instruments/mouth/arch_curve.h"

namespace tactooth {
namespace {

constexpr int kPlaces = 8;          // teeth of a quadrant
constexpr double kRoom = 9;         // mm around the teeth, for the numbers
constexpr double kBetweenJaws = 7;  // mm
constexpr double kGap = 0.3;        // mm between the outlines of neighbours

/// The largest diameters of a crown, mm, from the central incisor to the third molar (Wheeler's Dental Anatomy).
struct CrownSize {
    double mesiodistal, buccolingual;
};
constexpr std::array<CrownSize, kPlaces> kUpper = {
    {{8.5, 7}, {6.5, 6}, {7.5, 8}, {7, 9}, {7, 9}, {10, 11}, {9, 11}, {8.5, 10}}};
constexpr std::array<CrownSize, kPlaces> kLower = {
    {{5, 6}, {5.5, 6.5}, {7, 7.5}, {7, 7.5}, {7, 8}, {11, 10.5}, {10.5, 10}, {10, 9.5}}};

/// The outline is |x/a|^n + |y/b|^n = 1: a canine is nearly a rhomb, a molar nearly a rectangle.
double squareness(int place) {
    if (place <= 2) return 2.6;
    if (place == 3) return 1.7;
    return place <= 5 ? 2.2 : 3.2;
}

std::vector<Vec2> outlineOf(int place, const CrownSize& crown) {
    constexpr int kCorners = 48;
    std::vector<Vec2> outline;
    const double power = 2 / squareness(place);
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        const double x = std::cos(angle), y = std::sin(angle);
        outline.emplace_back((crown.mesiodistal - kGap) / 2 * std::copysign(std::pow(std::abs(x), power), x),
                             crown.buccolingual / 2 * std::copysign(std::pow(std::abs(y), power), y));
    }
    return outline;
}

/// The edge of an anterior tooth, the fissure of a premolar, the cross of fissures of a molar.
std::vector<std::vector<Vec2>> linesOf(int place, const CrownSize& crown) {
    const double along = 0.3 * crown.mesiodistal, across = 0.28 * crown.buccolingual;
    if (place <= 3) return {{Vec2(-along, 0), Vec2(0, place == 3 ? 0.1 * crown.buccolingual : 0), Vec2(along, 0)}};
    std::vector<std::vector<Vec2>> lines = {{Vec2(-along, 0), Vec2(along, 0)}};
    if (place >= 6) lines.push_back({Vec2(0, -across), Vec2(0, across)});
    return lines;
}

/// Upper teeth in their own frame: x to the right of the picture, y down, the incisors at the top at y = 0.
ChartTooth placed(int fdi) {
    const int place = fdi % 10;
    const bool isUpper = fdi < 30, isPatientsRight = fdi / 10 == 1 || fdi / 10 == 4;
    const auto& crowns = isUpper ? kUpper : kLower;
    double s = 0;
    for (int before = 1; before < place; ++before) s += crowns[static_cast<std::size_t>(before - 1)].mesiodistal;
    const CrownSize& crown = crowns[static_cast<std::size_t>(place - 1)];
    s += crown.mesiodistal / 2;
    const ArchCurve::Place there = ArchCurve().at(isPatientsRight ? s : -s);
    // The dentist looks at the patient: right is left, and what is in front is at the top of an upper arch.
    const double turned = isUpper ? -1 : 1;
    const auto onChart = [&](const Vec3& v) { return Vec2(-v.x(), turned * v.y()); };
    ChartTooth tooth;
    tooth.fdi = fdi;
    tooth.centre = onChart(there.point);
    tooth.outward = onChart(there.outward);
    const Vec2 along = onChart(there.along);
    const auto inPlace = [&](std::vector<Vec2>& corners) {
        for (Vec2& corner : corners) corner = tooth.centre + corner.x() * along + corner.y() * tooth.outward;
    };
    tooth.outline = outlineOf(place, crown);
    inPlace(tooth.outline);
    tooth.lines = linesOf(place, crown);
    for (auto& line : tooth.lines) inPlace(line);
    return tooth;
}

void shift(ChartTooth& tooth, const Vec2& by) {
    tooth.centre += by;
    for (Vec2& corner : tooth.outline) corner += by;
    for (auto& line : tooth.lines) {
        for (Vec2& corner : line) corner += by;
    }
}

/// FDI number of a place in a row, from left to right.
int fdiInRow(int row, int column) {
    const int quadrants[2][2] = {{1, 2}, {4, 3}};
    return column < kPlaces ? 10 * quadrants[row][0] + kPlaces - column : 10 * quadrants[row][1] + column - kPlaces + 1;
}

Eigen::AlignedBox2d boxOf(const ToothChartLayout& layout, std::size_t first) {
    Eigen::AlignedBox2d box;
    for (std::size_t i = first; i < first + 2 * kPlaces; ++i) {
        for (const Vec2& corner : layout.teeth[i].outline) box.extend(corner);
    }
    return box;
}

}  // namespace

ToothChartLayout toothChartLayout() {
    ToothChartLayout layout;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2 * kPlaces; ++column) {
            layout.teeth[static_cast<std::size_t>(2 * kPlaces * row + column)] = placed(fdiInRow(row, column));
        }
    }
    const Eigen::AlignedBox2d upper = boxOf(layout, 0), lower = boxOf(layout, std::size_t{2 * kPlaces});
    const double halfWidth = std::max(upper.sizes().x(), lower.sizes().x()) / 2 + kRoom;
    const double lowerTop = kRoom + upper.sizes().y() + kBetweenJaws;
    for (std::size_t i = 0; i < layout.teeth.size(); ++i) {
        const bool isUpper = i < std::size_t{2 * kPlaces};
        shift(layout.teeth[i], Vec2(halfWidth, isUpper ? kRoom - upper.min().y() : lowerTop - lower.min().y()));
    }
    layout.size = Vec2(2 * halfWidth, lowerTop + lower.sizes().y() + kRoom);
    return layout;
}

int toothBeside(int fdi, ChartStep step) {
    TACTOOTH_ASSERT(isPermanentTooth(fdi));
    int row = fdi < 30 ? 0 : 1;
    int column = 0;
    while (fdiInRow(row, column) != fdi) ++column;
    if (step == ChartStep::Left) column = std::max(0, column - 1);
    if (step == ChartStep::Right) column = std::min(2 * kPlaces - 1, column + 1);
    if (step == ChartStep::Up) row = 0;
    if (step == ChartStep::Down) row = 1;
    return fdiInRow(row, column);
}

}  // namespace tactooth

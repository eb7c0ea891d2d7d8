// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/root_variation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "instruments/anatomy/deviation.h"

namespace tactooth {
namespace {

// mm that an apex moves beside the swing of the mouth: the roots of a tooth together, and each by itself. In measured
// teeth they differ by up to 2 mm mesiodistally.
constexpr double kTogether = 0.15, kAlone = 0.25, kAloneAside = 0.3;
constexpr double kThirdMolar = 0.5;  // share of all this: its roots are strongly curved already

struct RootCurve {
    double from, apex;  ///< heights
    double x, y;        ///< displacement of the apex
};

void curve(Section& section, const RootCurve& by) {
    const double part = std::max(0.0, (by.from - section.z) / (by.from - by.apex));
    section.x += by.x * part * part;
    section.y += by.y * part * part;
}

/// The level section of an oblique canal is longer than the canal is wide: it must not become narrower than its mesh
/// can show.
void curveCanal(Section& section, const RootCurve& by) {
    curve(section, by);
    const double length = by.from - by.apex, part = std::max(0.0, (by.from - section.z) / length);
    const double slope = 2 * std::hypot(by.x, by.y) * part / length;
    for (double* half : {&section.plusX, &section.minusX, &section.plusY, &section.minusY}) *half *= 1 + slope;
}

/// The root in which a canal ends.
std::size_t rootOfCanal(const PosteriorToothPlan& plan, const Section& end) {
    std::size_t root = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < plan.roots.size(); ++i) {
        const Section there = SectionLoft(plan.roots[i].sections).at(end.z);
        const double away = std::hypot(there.x - end.x, there.y - end.y);
        if (away < nearest) {
            nearest = away;
            root = i;
        }
    }
    return root;
}

}  // namespace

void curveRoots(PosteriorToothPlan& plan, const RootSwing& swing, std::mt19937& random) {
    const double share = plan.fdi % 10 == 8 ? kThirdMolar : 1;
    const double x = swing.mesial + deviation(random, kTogether);
    std::vector<RootCurve> curves;
    for (const RootPlan& root : plan.roots) {
        const double aloneX = deviation(random, kAlone), aloneY = deviation(random, kAloneAside);
        curves.push_back({plan.trunkEnd, root.apex, share * (x + aloneX), share * (swing.buccal + aloneY)});
    }
    for (std::vector<Section>& canal : plan.canals) {
        const RootCurve& by = curves[rootOfCanal(plan, canal.front())];
        for (Section& section : canal) curveCanal(section, by);
    }
    for (std::size_t i = 0; i < plan.roots.size(); ++i) {
        constexpr double kMargin = 0.5;  // mm
        for (Section& s : plan.roots[i].sections) {
            curve(s, curves[i]);
            plan.bounds.extend(Vec3(s.x - s.minusX - kMargin, s.y - s.minusY - kMargin, s.z));
            plan.bounds.extend(Vec3(s.x + s.plusX + kMargin, s.y + s.plusY + kMargin, s.z));
        }
    }
}

}  // namespace tactooth

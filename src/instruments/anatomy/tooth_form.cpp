// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/tooth_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr double kTopHeight = 1.1;  // share of the crown's length: sections end above the cusps

/// Half width at a share of the crown's length: from the neck to the crest and on to the top.
double sideAt(double height, double neck, double crest, double most, double top, double flare) {
    if (height <= crest) {
        const double grown = std::sin(std::numbers::pi / 2 * std::max(height, 0.0) / crest);
        return neck + (most - neck) * std::pow(grown, flare);
    }
    const double above = (height - crest) / (kTopHeight - crest);
    constexpr double kCurl = 1.8;  // 1: straight to the top, 2: a parabola
    return most + (top - most) * std::pow(above, kCurl);
}

/// Below the neck: the remaining share of the neck's half width.
struct TrunkStep {
    double z, part;  // part: 0 at the neck, 1 where it is narrowest
};
constexpr std::array<TrunkStep, 3> kTrunk = {{{-4.2, 1.0}, {-2.6, 0.48}, {-1.0, 0.09}}};

// Half widths of the root, as shares of those at the neck, over the share of its length: mesiodistally and
// buccolingually. It keeps its width for half its length and ends in a round tip.
struct RootStep {
    double down, mesiodistal, buccolingual;
};
constexpr std::array<RootStep, 10> kRoot = {{{1.000, 0.11, 0.09},
                                             {0.989, 0.22, 0.17},
                                             {0.962, 0.34, 0.28},
                                             {0.900, 0.48, 0.43},
                                             {0.757, 0.63, 0.62},
                                             {0.568, 0.76, 0.80},
                                             {0.379, 0.87, 0.92},
                                             {0.190, 0.95, 0.98},
                                             {0.070, 0.985, 0.995},
                                             {0.000, 1.0, 1.0}}};

/// A parabola through neck and apex, drawn to the bend.
double centreAt(double down, double neck, double bend, double apex) {
    const double up = 1 - down;
    return up * up * neck + 2 * up * down * bend + down * down * apex;
}

}  // namespace

std::vector<Section> crownSections(const CrownForm& form) {
    const double cervixX = form.cervixMesiodistal / 2, cervixY = form.cervixBuccolingual / 2;
    std::vector<Section> sections;
    for (const auto& [z, part] : kTrunk) {
        const double left = 1 - (1 - form.trunkNarrowing) * part;
        sections.push_back(
            {z, left * cervixX, left * cervixX, left * cervixY, left * cervixY, form.cervixSquareness, 0, 0});
    }
    const double halfX = form.mesiodistal / 2, buccal = form.buccolingual / 2 + form.buccalShift,
                 lingual = form.buccolingual / 2 - form.buccalShift;
    for (const double height : {0.0, 0.13, 0.27, 0.40, 0.52, 0.64, 0.76, 0.88, kTopHeight}) {
        Section s;
        s.z = height * form.length;
        s.plusX = sideAt(height, cervixX, form.mesialContact, halfX, form.mesialTop * halfX, form.flare);
        s.minusX = sideAt(height, cervixX, form.distalContact, halfX, form.distalTop * halfX, form.flare);
        s.plusY = sideAt(height, cervixY, form.buccalCrest, buccal, form.buccalTop * buccal, form.flare);
        s.minusY = sideAt(height, cervixY, form.lingualCrest, lingual, form.lingualTop * lingual, form.flare);
        s.squareness = std::lerp(form.cervixSquareness, form.topSquareness, std::min(height, 1.0));
        sections.push_back(s);
    }
    return sections;
}

std::vector<Section> rootSections(const RootForm& form) {
    std::vector<Section> sections;
    for (const auto& [down, mesiodistal, buccolingual] : kRoot) {
        const double a = form.halfMesiodistal * std::pow(mesiodistal, 1 / form.fullness),
                     b = form.halfBuccolingual * std::pow(buccolingual, 1 / form.fullness);
        const double squareness = std::lerp(form.squareness, 2.0, down);
        sections.push_back({-down * form.length, a, a, b, b, squareness,
                            centreAt(down, form.cervixX, form.bendX, form.apexX),
                            centreAt(down, form.cervixY, form.bendY, form.apexY)});
    }
    return sections;
}

std::vector<Section> canalSections(const RootForm& root, const CanalForm& form) {
    constexpr double kEnd = 0.945, kEndRadius = 0.16;  // share of the root's length; mm
    constexpr std::array<double, 5> kDown = {kEnd, 0.75, 0.5, 0.25, 0.0};
    std::vector<Section> sections;
    for (const double down : kDown) {
        const double part = 1 - down / kEnd, widening = std::pow(part, 1.2);
        const double a = std::lerp(kEndRadius, form.halfMesiodistal, widening),
                     b = std::lerp(kEndRadius, form.halfBuccolingual, widening);
        const double spread = 4 * down / kEnd * part;  // away from the middle of the root at half its length, and back
        constexpr double kIntoChamber = 0.75;  // share of the root's position at the neck: the chamber is smaller
        const double inward = std::lerp(kIntoChamber, 1.0, std::min(1.0, down / 0.25));
        sections.push_back(
            {down > 0 ? -down * root.length : 0.4, a, a, b, b, 2,
             inward * centreAt(down, root.cervixX, root.bendX, root.apexX),
             inward * centreAt(down, root.cervixY, root.bendY, root.apexY) + form.aside * std::max(spread, part)});
    }
    return sections;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Lower right first molar (46). Lengths and diameters: Wheeler's table of average teeth; pulp chamber: A. S. Deutsch,
// B. L. Musikant, J. Endod. 30 (2004) 388. Everything else is modelled after textbook drawings.
#include <algorithm>
#include <cmath>
#include <memory>

#include "instruments/anatomy/tooth_shape.h"
#include "instruments/modelling/blend.h"
#include "instruments/modelling/section_loft.h"

namespace tactooth {
namespace {

// z, mesial, distal, buccal, lingual, squareness. Widest mesiodistally at the contacts (z = 5), buccally near the neck,
// lingually in the middle.
constexpr Section kCrown[] = {{-4.2, 2.9, 2.8, 2.6, 2.6, 2.4, 0, 0},     {-2.6, 3.75, 3.70, 3.65, 3.60, 2.5, 0, 0},
                              {-1.0, 4.30, 4.28, 4.38, 4.28, 2.5, 0, 0}, {0.0, 4.42, 4.45, 4.60, 4.50, 2.5, 0, 0},
                              {1.2, 4.66, 4.80, 5.08, 4.74, 2.5, 0, 0},  {2.3, 5.22, 5.16, 5.32, 5.02, 2.45, 0, 0},
                              {3.8, 5.45, 5.40, 5.12, 5.22, 2.4, 0, 0},  {5.0, 5.54, 5.48, 4.58, 5.07, 2.3, 0, 0},
                              {6.2, 5.25, 5.15, 3.80, 4.62, 2.25, 0, 0}, {8.0, 4.60, 4.40, 2.90, 3.80, 2.2, 0, 0}};

constexpr Section kMesialRoot[] = {
    {-14.0, 0.24, 0.22, 0.35, 0.35, 2.0, 1.45, 0.1}, {-13.85, 0.50, 0.46, 0.72, 0.70, 2.0, 1.52, 0.1},
    {-13.5, 0.72, 0.68, 1.18, 1.15, 2.1, 1.62, 0.1}, {-12.7, 1.00, 0.96, 1.80, 1.75, 2.2, 1.88, 0.1},
    {-11.0, 1.28, 1.25, 2.60, 2.50, 2.4, 2.35, 0.0}, {-8.0, 1.55, 1.50, 3.40, 3.30, 2.5, 2.75, 0.0},
    {-5.0, 1.75, 1.65, 3.90, 3.80, 2.6, 2.70, 0.0},  {-2.5, 1.95, 1.90, 4.15, 4.05, 2.6, 2.35, 0.0},
    {0.0, 2.0, 2.0, 4.20, 4.10, 2.6, 2.1, 0.0}};

constexpr Section kDistalRoot[] = {
    {-13.2, 0.22, 0.22, 0.32, 0.32, 2.0, -3.75, 0.0}, {-13.05, 0.46, 0.46, 0.66, 0.64, 2.0, -3.74, 0.0},
    {-12.7, 0.68, 0.68, 1.08, 1.05, 2.1, -3.71, 0.0}, {-11.9, 0.93, 0.93, 1.60, 1.56, 2.2, -3.63, 0.0},
    {-10.0, 1.22, 1.22, 2.30, 2.25, 2.3, -3.40, 0.0}, {-7.5, 1.48, 1.48, 3.05, 3.00, 2.4, -3.05, 0.0},
    {-5.0, 1.65, 1.72, 3.65, 3.55, 2.5, -2.70, 0.0},  {-2.5, 1.85, 1.90, 4.00, 3.90, 2.6, -2.40, 0.0},
    {0.0, 1.9, 2.0, 4.10, 4.00, 2.6, -2.2, 0.0}};

/// A cusp is a rounded pyramid: ridges run from its tip inward, outward and along the row of cusps.
struct Cusp {
    double x, y, z;          // tip
    double inX, inY;         // unit, the way of its ridge toward the middle of the crown
    double inward, outward;  // slopes of those ridges
    double along;            // slope of the ridges beside them
};

// Heights, positions and slopes in mm and mm/mm; the lingual cusps are the higher ones, as the tooth leans.
constexpr Cusp kCusps[] = {{2.55, 2.55, 7.15, -0.22, -0.975, 0.84, 1.10, 0.62},   // mesiobuccal
                           {-0.75, 2.80, 6.95, 0.05, -0.999, 0.80, 1.10, 0.70},   // distobuccal
                           {-3.45, 1.55, 6.45, 0.75, -0.661, 0.66, 1.00, 0.72},   // distal
                           {2.45, -2.80, 7.50, -0.20, 0.980, 0.86, 1.35, 0.58},   // mesiolingual
                           {-1.75, -2.85, 7.30, 0.18, 0.984, 0.84, 1.35, 0.62}};  // distolingual

/// Ridge along a straight line, with the same slope to both sides.
struct Ridge {
    double ax, ay, bx, by, z, slope;
};

constexpr Ridge kMarginalRidges[] = {{4.45, 1.3, 4.45, -1.5, 5.95, 0.95}, {-4.65, 0.2, -4.35, -1.7, 5.65, 0.95}};

struct Groove {
    double ax, ay, bx, by, depth, width;
};

// The central groove zigzags from the mesial to the distal pit; grooves leave it between the cusps.
constexpr Groove kGrooves[] = {{3.45, -0.15, 1.05, -0.30, 0.36, 0.42},  {1.05, -0.30, -0.60, 0.15, 0.38, 0.42},
                               {-0.60, 0.15, -3.25, -0.55, 0.36, 0.42}, {1.05, -0.30, 1.00, 4.6, 0.38, 0.44},
                               {-2.15, 0.0, -2.50, 4.0, 0.34, 0.42},    {0.40, -0.15, 0.45, -4.9, 0.36, 0.44},
                               {3.45, -0.15, 4.05, 0.85, 0.26, 0.38},   {3.45, -0.15, 4.05, -1.1, 0.26, 0.38},
                               {-3.25, -0.55, -3.95, -1.5, 0.26, 0.38}, {2.3, -0.2, 3.1, 1.9, 0.13, 0.35},
                               {0.3, 0.0, -0.05, 1.9, 0.13, 0.35},      {-1.5, 0.0, -1.6, 1.9, 0.12, 0.32},
                               {2.2, -0.25, 3.2, -1.9, 0.13, 0.35},     {-0.5, 0.0, -0.7, -2.0, 0.13, 0.35},
                               {-2.4, -0.2, -2.9, -1.9, 0.12, 0.35}};

struct Pit {
    double x, y, depth, width;
};

constexpr Pit kPits[] = {{1.05, -0.30, 0.22, 0.50}, {3.45, -0.15, 0.22, 0.45}, {-3.25, -0.55, 0.22, 0.45}};

double distanceToSegment(double x, double y, double ax, double ay, double bx, double by) {
    const double dx = bx - ax, dy = by - ay;
    const double part = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(x - ax - part * dx, y - ay - part * dy);
}

/// |x| without its kink: ridges are rounded.
double softened(double x) {
    constexpr double kRound = 0.18;  // mm
    return std::sqrt(x * x + kRound * kRound) - kRound;
}

double cuspHeight(const Cusp& cusp, double x, double y) {
    const double dx = x - cusp.x, dy = y - cusp.y;
    const double in = dx * cusp.inX + dy * cusp.inY, beside = dx * cusp.inY - dy * cusp.inX;
    const double a = softened(in) * (in > 0 ? cusp.inward : cusp.outward), b = softened(beside) * cusp.along;
    constexpr double kPyramid = 1.3;  // 1: four sharp ridges, 2: a round cone
    constexpr double kTip = 0.45;     // mm of height that the rounding takes from the tip
    const double drop = std::pow(std::pow(a, kPyramid) + std::pow(b, kPyramid), 1 / kPyramid);
    return cusp.z - std::sqrt(drop * drop + kTip * kTip) + kTip;
}

/// Height of the occlusal surface without its grooves.
double smoothOcclusal(double x, double y) {
    constexpr double kFossa = 4.75;      // mm, height that no part of the surface falls below
    constexpr double kBlend = 0.55;      // mm, over which slopes run into each other
    constexpr double kRidgeRound = 0.4;  // mm, of a marginal ridge's crest
    double height = kFossa;
    for (const Cusp& cusp : kCusps) height = -smoothUnion(-height, -cuspHeight(cusp, x, y), kBlend);
    for (const Ridge& ridge : kMarginalRidges) {
        const double away = distanceToSegment(x, y, ridge.ax, ridge.ay, ridge.bx, ridge.by);
        const double ridgeHeight = ridge.z - ridge.slope * (std::hypot(away, kRidgeRound) - kRidgeRound);
        height = -smoothUnion(-height, -ridgeHeight, kBlend);
    }
    return height;
}

double grooveDepth(double x, double y) {
    double deepest = 0;
    for (const Groove& g : kGrooves) {
        deepest = std::max(deepest, g.depth * bump(distanceToSegment(x, y, g.ax, g.ay, g.bx, g.by), g.width));
    }
    for (const Pit& pit : kPits) deepest += pit.depth * bump(std::hypot(x - pit.x, y - pit.y), pit.width);
    return deepest;
}

/// The crown is narrower lingually and distally: coordinates in which it is not.
Vec3 straightened(const Vec3& p) {
    return {p.x() / (1 + 0.016 * std::clamp(p.y(), -6.0, 6.0)), p.y() / (1 + 0.008 * std::clamp(p.x(), -6.0, 6.0)),
            p.z()};
}

// Root canals, as sections: the two mesial ones are round and meet near the apex, the distal one is broad.
constexpr Section kMesiobuccalCanal[] = {{-13.3, 0.13, 0.13, 0.13, 0.13, 2, 1.60, 0.35},
                                         {-9.0, 0.21, 0.21, 0.24, 0.24, 2, 2.65, 1.35},
                                         {-4.0, 0.30, 0.30, 0.33, 0.33, 2, 2.70, 1.90},
                                         {0.3, 0.42, 0.42, 0.45, 0.45, 2, 1.90, 1.20}};
constexpr Section kMesiolingualCanal[] = {{-13.3, 0.13, 0.13, 0.13, 0.13, 2, 1.60, -0.25},
                                          {-9.0, 0.21, 0.21, 0.24, 0.24, 2, 2.65, -1.25},
                                          {-4.0, 0.30, 0.30, 0.33, 0.33, 2, 2.70, -1.80},
                                          {0.3, 0.42, 0.42, 0.45, 0.45, 2, 1.90, -1.20}};
constexpr Section kDistalCanal[] = {{-12.5, 0.14, 0.14, 0.18, 0.18, 2, -3.68, 0},
                                    {-8.5, 0.27, 0.27, 0.60, 0.60, 2, -3.20, 0},
                                    {-4.0, 0.40, 0.40, 0.95, 0.95, 2, -2.60, 0},
                                    {0.3, 0.55, 0.55, 1.10, 1.10, 2, -1.95, 0}};

double canal(const SectionLoft& loft, const Vec3& p, double end) {
    return std::max(smoothIntersection(loft(p), end - p.z(), 0.15), p.z() - 0.3);
}

// Heights beyond which a part of the tooth is so far from the rest that it need not be asked: cusps below the first,
// roots above it, the crown's trunk below the second.
constexpr double kBelowCusps = 0.5, kBelowTrunk = -4.8;

class Molar {
public:
    [[nodiscard]] double outer(const Vec3& p) const { return body(p, true); }

    /// Enamel is thinner under a groove: the core does not follow it.
    [[nodiscard]] double core(const Vec3& p) const {
        const double surface = body(p, true), height = cervical(p);
        if (height <= 0) return surface;
        const double thickness = enamel(p, height);
        return std::max(body(p, false) + thickness, surface + kThinnest * thickness);
    }

    [[nodiscard]] static double cervical(const Vec3& p) {
        constexpr double kMesialRise = 1.0, kDistalRise = 0.3, kSpur = 0.25;  // mm; enamel dips toward the furcation
        const double part = p.x() / 4.5;
        const double rise = (p.x() > 0 ? kMesialRise : kDistalRise) * part * part;
        return p.z() - rise + kSpur * (bump(p.x() + 0.2, 1.0) - 1);
    }

    [[nodiscard]] double pulp(const Vec3& p) const;

private:
    [[nodiscard]] double body(const Vec3& p, bool grooved) const {
        if (p.z() < kBelowTrunk) return roots(p);
        if (p.z() < kBelowCusps) return smoothUnion(trunk(p), roots(p), kFillet);
        return smoothIntersection(wall(p), occlusal(p, grooved ? grooveDepth(p.x(), p.y()) : 0), kFillet);
    }

    /// Sides of the crown with their developmental grooves and the step at the cervical line.
    [[nodiscard]] double wall(const Vec3& p) const {
        double distance = crown_(straightened(p));
        const double high = smoothStep(1.5, 4.5, p.z());
        if (p.y() > 0) {
            distance += high * (0.38 * bump(p.x() - 1.10, 0.55) + 0.30 * bump(p.x() + 2.55, 0.5));
        } else {
            distance += high * 0.34 * bump(p.x() - 0.50, 0.6);
        }
        constexpr double kStep = 0.07;  // mm by which the crown stands out over the root
        return distance + kStep * (1 - smoothStep(-0.15, 0.35, cervical(p)));
    }

    [[nodiscard]] static double occlusal(const Vec3& p, double groove) {
        constexpr double kSlope = 1.25;  // length of the height function's gradient, typically
        return (p.z() - smoothOcclusal(p.x(), p.y()) + groove) / kSlope;
    }

    [[nodiscard]] double trunk(const Vec3& p) const {
        constexpr double kTrunkEnd = -2.9;  // mm; with its rounding, the furcation lies at about -3.5
        constexpr double kArch = 1.6;       // mm
        return smoothIntersection(wall(p), kTrunkEnd - p.z(), kArch);
    }

    /// Both roots, which begin within the trunk. Their broad sides are hollowed, the mesial one's more.
    [[nodiscard]] double roots(const Vec3& p) const {
        constexpr double kMesialApex = -14.05, kDistalApex = -13.25, kTop = -0.8;  // mm
        constexpr double kApexRound = 0.25, kTopRound = 1.2, kHollow = 0.35;       // mm
        const double hollow =
            kHollow * bump(p.y(), 1.4) * smoothStep(-1.5, -4.5, p.z()) * smoothStep(-13.0, -10.0, p.z());
        const double mesial = smoothIntersection(mesialRoot_(p) + hollow, kMesialApex - p.z(), kApexRound);
        const double distal = smoothIntersection(distalRoot_(p) + 0.6 * hollow, kDistalApex - p.z(), kApexRound);
        return smoothIntersection(smoothUnion(mesial, distal, kFillet), p.z() - kTop, kTopRound);
    }

    /// Thickness of the enamel at a height above the cervical line: a feather edge, 1.3 mm at the sides, more on top.
    [[nodiscard]] static double enamel(const Vec3& p, double height) {
        constexpr double kThickness = 1.5, kFeather = 1.7;
        const double functional = 0.15 * smoothStep(-1.0, 2.5, p.y());  // buccal cusps carry the load
        return (kThickness + functional) * (1 - std::exp(-height / kFeather));
    }

    static constexpr double kFillet = 0.9;    // mm, over which surfaces run into each other
    static constexpr double kThinnest = 0.4;  // of the enamel's thickness, left under the deepest groove

    SectionLoft crown_{kCrown}, mesialRoot_{kMesialRoot}, distalRoot_{kDistalRoot};
    SectionLoft mesiobuccalCanal_{kMesiobuccalCanal}, mesiolingualCanal_{kMesiolingualCanal},
        distalCanal_{kDistalCanal};
};

/// Chamber between z = -0.45 and 1.1 (6.4 mm and 8 mm below the highest cusp), a horn under each cusp, two mesial
/// canals and one broad distal canal.
double Molar::pulp(const Vec3& p) const {
    constexpr double kRound = 0.7;
    const Vec3 out = (p - Vec3(-0.1, 0, 0.33)).cwiseAbs() - Vec3(2.55 - kRound, 2.0 - kRound, 0.78 - kRound);
    double chamber = out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0) - kRound;
    for (const Cusp& cusp : kCusps) {
        const Vec3 base(0.66 * cusp.x, 0.48 * cusp.y, 0.4), tip(0.80 * cusp.x, 0.62 * cusp.y, cusp.z - 5.0);
        chamber = smoothUnion(chamber, taperedCapsule(p, base, 0.62, tip, 0.15), 0.5);
    }
    const double canals =
        std::min({canal(mesiobuccalCanal_, p, kMesiobuccalCanal[0].z),
                  canal(mesiolingualCanal_, p, kMesiolingualCanal[0].z), canal(distalCanal_, p, kDistalCanal[0].z)});
    return smoothUnion(chamber, canals, 0.4);
}

}  // namespace

ToothShape lowerFirstMolar() {
    const auto molar = std::make_shared<const Molar>();
    ToothShape shape;
    shape.name = "Lower right first molar";
    shape.fdi = 46;
    shape.bounds = Box3(Vec3(-6.5, -6.5, -14.8), Vec3(6.5, 6.5, 8.2));
    shape.outer = [molar](const Vec3& p) { return molar->outer(p); };
    shape.core = [molar](const Vec3& p) { return molar->core(p); };
    shape.cervical = &Molar::cervical;
    shape.pulp = [molar](const Vec3& p) { return molar->pulp(p); };
    shape.lesionSite = Vec3(1.05, -0.30, smoothOcclusal(1.05, -0.30) - grooveDepth(1.05, -0.30));
    shape.lesionInward = -Vec3::UnitZ();
    shape.lesionEnamel = 0.9;
    return shape;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/anterior_tooth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "geometry/util/assert.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

/// The same outlines with their widest point in the middle between the labial and the lingual face.
std::vector<Section> centred(std::vector<Section> sections) {
    for (Section& s : sections) {
        const double half = (s.plusY + s.minusY) / 2;
        s.y += (s.plusY - s.minusY) / 2;
        s.plusY = s.minusY = half;
    }
    return sections;
}

/// Root and canal lean together: a bend below the neck that becomes straight toward the apex.
std::vector<Section> leaning(std::vector<Section> sections, const AnteriorToothPlan& plan) {
    for (Section& s : sections) {
        if (s.z >= 0) continue;
        constexpr double kBend = 1.35;  // power: 1 is a kink at the neck, 2 a parabola
        const double part = std::pow(s.z / plan.apex, kBend);
        s.x -= plan.distally * part;
        s.y -= plan.lean * part;
    }
    return sections;
}

/// The share of a ridge's height at a distance from its line, given by its square over that of four half widths: a bump
/// that ends.
double fading(double square) {
    if (square >= 1) return 0;
    const double left = (1 - square) * (1 - square);
    return left * left;
}

/// The height of a ridge at a place of the face.
double heightOf(const FaceRidge& ridge, double x, double z) {
    const double reach = 1 / (4 * ridge.width * ridge.width);
    double height = 0;
    for (std::size_t i = 0; i + 1 < ridge.points.size(); ++i) {
        const FaceRidge::Point &a = ridge.points[i], &b = ridge.points[i + 1];
        const double alongX = b.x - a.x, alongZ = b.z - a.z;
        const double part =
            std::clamp(((x - a.x) * alongX + (z - a.z) * alongZ) / (alongX * alongX + alongZ * alongZ), 0.0, 1.0);
        const double dx = x - a.x - part * alongX, dz = z - a.z - part * alongZ;
        const double here = std::lerp(a.height, b.height, part) * fading(reach * (dx * dx + dz * dz));
        if (std::abs(here) > std::abs(height)) height = here;
    }
    return height;
}

constexpr std::size_t kMaxOutlines = 6;

class AnteriorTooth {
public:
    explicit AnteriorTooth(AnteriorToothPlan plan)
        : plan_(std::move(plan)),
          body_(leaning(centred(plan_.body), plan_)),
          pulp_(leaning(plan_.pulp, plan_)),
          fall_(plan_.fall),
          mesialLine_(halfWidth(plan_.mesialRise, 1)),
          distalLine_(halfWidth(plan_.distalRise, -1)) {}

    [[nodiscard]] double outer(const Vec3& p) const {
        constexpr double kApexBlend = 0.8, kEdgeBlend = 0.5;
        const Vec3 q = unbent(p);
        const double withApex = smoothIntersection(sides(q, p), plan_.apex - p.z(), kApexBlend);
        return smoothIntersection(withApex, edge(q), kEdgeBlend);
    }

    [[nodiscard]] double core(const Vec3& p) const {
        const double height = cervical(p), surface = outer(p);
        if (height <= 0) return surface;
        const Vec3 q = unbent(p);
        return smoothIntersection(surface + enamel(q, height), edge(q) + plan_.incisalEnamel, 0.6);
    }

    [[nodiscard]] double cervical(const Vec3& p) const {
        const double part = p.x() / (p.x() > 0 ? mesialLine_ : distalLine_);
        constexpr double kArch = 0.6;           // above the line the crown is wider: there it must hardly rise on
        constexpr double kTop = 1 - kArch / 4;  // of smoothUnion where both are 1
        const double risen = smoothUnion(part * part, 1, kArch) / kTop;
        return p.z() - (p.x() > 0 ? plan_.mesialRise : plan_.distalRise) * risen;
    }

    [[nodiscard]] double pulp(const Vec3& p) const {
        constexpr double kBlend = 0.3;
        const double canal = smoothIntersection(pulp_(p), plan_.pulp.front().z - p.z(), kBlend);
        return smoothIntersection(canal, p.z() - plan_.pulp.back().z, kBlend);
    }

private:
    /// The point of the straight stack of sections for one of the crown.
    [[nodiscard]] Vec3 unbent(const Vec3& p) const {
        if (p.z() <= 0) return p;
        const Section s = body_.at(p.z());
        const double grown = smoothStep(0.1, 0.75, p.z() / plan_.edgeZ), begun = smoothStep(0, 2.5, p.z());
        const CrownBend& bend = plan_.bend;
        const double aside = p.x() - s.x, part = std::clamp(aside / (aside > 0 ? s.plusX : s.minusX), -1.3, 1.3);
        const double behind = (aside > 0 ? bend.mesialArch : bend.distalArch) * part * part - bend.turn * part;
        const double y = p.y() + grown * behind;
        const double ahead = std::clamp((y - s.y) / s.plusY, -1.2, 1.2);
        const double x = (aside - begun * bend.shear * (y - s.y)) / (1 + begun * bend.taper * ahead);
        return {s.x + x, y, p.z()};
    }

    /// Thickness of the enamel at a height above the cervical line: a feather edge, then a steady growth to the edge.
    /// It is thinnest on the lingual face, and thickest at the proximal sides of the cervical half.
    [[nodiscard]] double enamel(const Vec3& q, double height) const {
        constexpr double kNeck = 0.36, kFeather = 0.4;  // share of the thickness near the neck; mm
        const double share = height / (height + std::max(plan_.edgeZ - q.z(), 0.0));
        const double grown = kNeck * (1 - std::exp(-height / kFeather)) + (1 - kNeck) * smoothStep(0.05, 0.85, share);
        const Section section = body_.at(q.z());
        constexpr double kLingual = 0.6, kContact = 0.95, kProximal = 1.2;  // of the labial thickness
        const double lingual = std::lerp(1.0, kLingual, smoothStep(0.1, 0.6, share));
        const double proximal = std::lerp(kProximal, kContact, smoothStep(0.4, 0.8, share));
        const double labially = smoothStep(-0.7, 0.7, (q.y() - section.y) / section.plusY);
        const double aside = q.x() - section.x;
        const double proximally = smoothStep(0.5, 0.95, std::abs(aside) / (aside > 0 ? section.plusX : section.minusX));
        const double around = std::lerp(std::lerp(lingual, 1.0, labially), proximal, proximally);
        return plan_.enamelThickness * grown * around;
    }

    /// mm that the outline stands outside of the section's oval: de Casteljau's algorithm.
    [[nodiscard]] double outline(const Vec3& q, const Section& section) const {
        const std::size_t order = plan_.outlines.size();
        const double dx = q.x() - section.x, dy = q.y() - section.y;
        const double x = dx / (dx > 0 ? section.plusX : section.minusX), y = dy / section.plusY;
        std::array<double, kMaxOutlines + 1> offsets{};
        for (std::size_t i = 0; i < order; ++i) offsets[i + 1] = outlineOffset(plan_.outlines[i], x, y);
        const double part = std::clamp(q.z() / plan_.edgeZ, 0.0, 1.0);
        for (std::size_t left = order; left > 0; --left) {
            for (std::size_t i = 0; i < left; ++i) offsets[i] = std::lerp(offsets[i], offsets[i + 1], part);
        }
        constexpr double kInner = 0.2, kOuter = 0.8;  // shares of the distance from the axis: there it has no direction
        return smoothStep(kInner, kOuter, std::hypot(x, y)) * offsets[0];
    }

    /// That of the crown at a height, to mesial (1) or to distal (-1).
    [[nodiscard]] double halfWidth(double z, double side) const {
        const Section s = body_.at(z);
        const double half = side > 0 ? s.plusX : s.minusX;
        return half + outline({s.x + side * half, s.y, z}, s);
    }

    /// The distance to the sides: `q` is the point `p` unbent.
    [[nodiscard]] double sides(const Vec3& q, const Vec3& p) const {
        constexpr double kStep = 0.07;  // mm that the crown protrudes over the root
        const double oval = body_(q) + kStep * (1 - smoothStep(-0.15, 0.35, cervical(p)));
        constexpr double kFar = 2;  // mm: the surface is not there
        if (q.z() <= 0 || std::abs(oval) > kFar) return oval;
        const Section section = body_.at(q.z());
        const double distance = oval - outline(q, section);
        const double fromMiddle = (q.y() - section.y) / section.plusY;
        double relief = 0;
        for (const FaceRidge& r : fromMiddle > 0 ? plan_.labial : plan_.lingual) relief += heightOf(r, q.x(), q.z());
        // So that neither face gets the ridges of the other.
        return distance - relief * smoothStep(0.0, 0.6, std::abs(fromMiddle));
    }

    [[nodiscard]] double edge(const Vec3& q) const {
        const auto [fall, slope] = fall_(q.x());
        const double aside = q.y() - plan_.crestY, round = plan_.edgeRoundness;
        const double bevel = aside > 0 ? plan_.labialBevel : plan_.lingualBevel;
        const double away = std::sqrt(aside * aside + round * round), steep = bevel * aside / away;
        const double height = q.z() - plan_.edgeZ + fall + bevel * (away - round);
        return height / std::sqrt(1 + slope * slope + steep * steep);
    }

    AnteriorToothPlan plan_;
    SectionLoft body_, pulp_;
    SmoothCurve fall_;
    double mesialLine_, distalLine_;  ///< half widths of the crown at the top of the cervical line
};

/// The point where the line from an inner point leaves the body.
Vec3 surfacePoint(const ScalarField& body, Vec3 inside, Vec3 outside) {
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
        const Vec3 middle = (inside + outside) / 2;
        (body(middle) < 0 ? inside : outside) = middle;
    }
    return inside;
}

}  // namespace

ToothShape anteriorTooth(const AnteriorToothPlan& plan) {
    TACTOOTH_ASSERT(plan.enamelThickness > 0 && plan.incisalEnamel > 0);
    TACTOOTH_ASSERT(plan.apex < 0 && plan.edgeZ > 0 && plan.outlines.size() <= kMaxOutlines);
    const auto tooth = std::make_shared<const AnteriorTooth>(plan);
    constexpr double kMargin = 0.8;
    ToothShape shape;
    shape.name = plan.name;
    shape.fdi = plan.fdi;
    shape.bounds = Box3(Vec3(-6, -6, plan.apex - kMargin), Vec3(6, 6, plan.edgeZ + kMargin));
    shape.outer = [tooth](const Vec3& p) { return tooth->outer(p); };
    shape.core = [tooth](const Vec3& p) { return tooth->core(p); };
    shape.cervical = [tooth](const Vec3& p) { return tooth->cervical(p); };
    shape.pulp = [tooth](const Vec3& p) { return tooth->pulp(p); };
    shape.lesionSite = surfacePoint(shape.outer, plan.lesionFrom, plan.lesionToward);
    shape.lesionInward = (plan.lesionFrom - plan.lesionToward).normalized();
    shape.lesionEnamel = (shape.lesionSite - surfacePoint(shape.core, plan.lesionFrom, shape.lesionSite)).norm();
    return shape;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/posterior_tooth.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "geometry/util/assert.h"
#include "instruments/anatomy/occlusal_surface.h"
#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

// Heights beyond which a part of the tooth is too far away to have an effect: cusps below the first, roots above it,
// and the trunk this much below its end.
constexpr double kBelowCusps = 0.5, kBelowTrunkEnd = 1.9;

constexpr double kFillet = 0.9;    // mm, over which surfaces blend
constexpr double kThinnest = 0.6;  // share of the enamel's thickness that is left under the deepest groove

constexpr double kLingualFrom = 0.5, kLingualTo = -4.0;  // mm to buccal: between them the cervical line rises lingually

class PosteriorTooth {
public:
    explicit PosteriorTooth(PosteriorToothPlan plan) : plan_(std::move(plan)), crown_(plan_.crown), table_(plan_) {
        for (const RootPlan& root : plan_.roots) roots_.emplace_back(root.sections);
        for (const std::vector<Section>& canal : plan_.canals) canals_.emplace_back(canal);
        for (const OcclusalGroove& groove : plan_.grooves) {
            deepestGroove_ = std::max({deepestGroove_, groove.depth, groove.endDepth});
        }
        for (const OcclusalPit& pit : plan_.pits) deepestGroove_ += pit.depth;
        for (const Cusp& cusp : plan_.cusps) {
            double& highest = cusp.y > 0 ? highestBuccally_ : highestLingually_;
            highest = std::max(highest, cusp.z);
        }
    }

    PosteriorTooth(const PosteriorTooth&) = delete;  // the table refers to the plan
    PosteriorTooth& operator=(const PosteriorTooth&) = delete;

    [[nodiscard]] const PosteriorToothPlan& plan() const { return plan_; }
    [[nodiscard]] double outer(const Vec3& p) const { return body(p).grooved; }

    /// Enamel is thinner under a groove: the core does not follow it.
    [[nodiscard]] double core(const Vec3& p) const {
        const Body surface = body(p);
        const double height = cervical(p);
        if (height <= 0) return surface.grooved;
        const double thickness = enamel(p, height, surface.side);
        return std::max(surface.smooth + thickness, surface.grooved + kThinnest * thickness);
    }

    [[nodiscard]] double cervical(const Vec3& p) const {
        const double part = p.x() / plan_.cervicalHalfWidth;
        const double rise = (p.x() > 0 ? plan_.mesialRise : plan_.distalRise) * part * part;
        const double lingually = smoothStep(kLingualFrom, kLingualTo, p.y());
        const double line = std::lerp(rise, std::max(rise, plan_.lingualRise), lingually);
        return p.z() - line + plan_.projection * (bump(p.x() - plan_.projectionX, 1.0) - 1);
    }

    [[nodiscard]] double pulp(const Vec3& p) const;

    /// The place of the occlusal surface over (x, y).
    [[nodiscard]] Vec3 occlusalPlace(double x, double y) const {
        return {x, y, table_.height(x, y) - table_.grooveDepth(x, y)};
    }

private:
    /// With the grooves of the occlusal surface and without.
    struct Body {
        double grooved, smooth;
        double side;  ///< the distance to the sides alone
    };
    [[nodiscard]] Body body(const Vec3& p) const {
        if (p.z() < plan_.trunkEnd - kBelowTrunkEnd) return both(roots(p));
        if (p.z() < kBelowCusps) return both(smoothUnion(trunk(p), roots(p), plan_.cervicalFillet));
        const double side = wall(p);
        if (side > occlusal(p.z() - table_.lowest() + deepestGroove_) + kFillet) return both(side);
        const double above = p.z() - table_.height(p.x(), p.y());
        return {smoothIntersection(side, occlusal(above + table_.grooveDepth(p.x(), p.y())), kFillet),
                smoothIntersection(side, occlusal(above), kFillet), side};
    }
    [[nodiscard]] static Body both(double distance) { return {distance, distance, distance}; }

    /// Coordinates in which the crown neither narrows to one side nor is skew.
    [[nodiscard]] Vec3 straightened(const Vec3& p) const {
        constexpr double kReach = 6.0;  // mm: farther away, the coordinates must not fold
        constexpr double kOnset = 2.5;  // mm
        const double skew = plan_.skew * smoothStep(plan_.skewFrom, plan_.skewFrom + kOnset, p.z());
        const double x = p.x() - skew * std::clamp(p.y(), -kReach, kReach);
        return {x / (1 + plan_.narrowsLingually * std::clamp(p.y(), -kReach, kReach)),
                p.y() / (1 + plan_.narrowsDistally * std::clamp(p.x(), -kReach, kReach)), p.z()};
    }

    /// Sides of the crown with their developmental grooves and the step at the cervical line.
    [[nodiscard]] double wall(const Vec3& p) const {
        double distance = crown_(straightened(p));
        const double high = smoothStep(1.5, 4.5, p.z());
        double furrow = 0;
        for (const DevelopmentalGroove& g : plan_.developmentalGrooves) {
            if (g.buccal == (p.y() > 0)) furrow += g.depth * bump(p.x() - g.x, g.width);
        }
        distance += high * furrow;
        if (plan_.tubercle && p.y() < 0) distance -= tubercle(p, *plan_.tubercle);
        constexpr double kNeck = 0.3, kFull = 3.0;  // mm: the waves grow from the neck to here
        distance -= smoothStep(kNeck, kFull, p.z()) * outlineOffset(plan_.outline, p.x(), p.y());
        constexpr double kStep = 0.07;  // mm that the crown protrudes over the root
        return distance + kStep * (1 - smoothStep(-0.15, 0.35, cervical(p)));
    }

    /// mm that the lingual side stands out at a tubercle, or lies back in its groove.
    [[nodiscard]] static double tubercle(const Vec3& p, const LingualTubercle& of) {
        constexpr double kUp = 0.8, kDown = 1.2;           // of the width: the upper side is the steeper one
        constexpr double kCrescent = 1.5, kNarrow = 0.32;  // of the width: the groove's way around, and its half width
        const double x = (p.x() - of.x) / of.width, above = (p.z() - of.z) / of.width;
        const double z = above / (above > 0 ? kUp : kDown), away = std::hypot(x, z);
        const double groove = of.groove * bump(away - kCrescent, kNarrow) * smoothStep(0, 0.8, z);
        constexpr double kFrom = -1, kTo = -3;  // mm to lingual, so that it grows smoothly from the middle of the tooth
        return smoothStep(kFrom, kTo, p.y()) * (of.height * bump(away, 1) - groove);
    }

    /// Approximate distance to the occlusal surface from a point at this height above it.
    [[nodiscard]] static double occlusal(double above) {
        constexpr double kSlope = 1.25;  // length of the height function's gradient, typically
        return above / kSlope;
    }

    [[nodiscard]] double trunk(const Vec3& p) const {
        constexpr double kArch = 1.6;  // mm
        return smoothIntersection(wall(p), plan_.trunkEnd - p.z(), kArch);
    }

    /// The roots, which begin inside the trunk. Their wide sides are concave.
    [[nodiscard]] double roots(const Vec3& p) const {
        constexpr double kApexRound = 0.25;  // mm
        double all = 0;
        for (std::size_t i = 0; i < roots_.size(); ++i) {
            const RootPlan& plan = plan_.roots[i];
            constexpr double kFade = 3.0;  // mm
            const double heights =
                smoothStep(-1.5, -4.5, p.z()) * smoothStep(plan.concavityEnd, plan.concavityEnd + kFade, p.z());
            const double concavity = plan.concavity * bump(p.y() - plan.concavityY, 1.4) * heights;
            const double root = smoothIntersection(roots_[i](p) + concavity, plan.apex - p.z(), kApexRound);
            all = i == 0 ? root : smoothUnion(all, root, kFillet);
        }
        return smoothIntersection(all, p.z() - plan_.rootTop, plan_.rootTopRound);
    }

    /// Thickness of the enamel at a height above the cervical line: a feather edge, then a steady growth to the cusps.
    /// `side`: distance to the sides of the crown; far from them lies the table.
    [[nodiscard]] double enamel(const Vec3& p, double height, double side) const {
        constexpr double kNeck = 0.30, kFeather = 0.4;  // share of the thickness near the neck; mm
        const double top = std::lerp(highestLingually_, highestBuccally_, smoothStep(-2, 2, p.y()));
        const double share = height / (height + std::max(top - p.z(), 0.0));
        constexpr double kTableFrom = 1.2, kTableTo = 2.2;  // mm from the sides
        const double grown = std::lerp(smoothStep(0.15, 0.8, share), 1.0, smoothStep(kTableFrom, kTableTo, -side));
        // These cusps carry the load.
        constexpr double kFunctional = 0.2;
        const double load = 1 + kFunctional * smoothStep(-1.0, 2.5, plan_.functionalSide * p.y());
        return plan_.enamel * load * (kNeck * (1 - std::exp(-height / kFeather)) + (1 - kNeck) * grown);
    }

    PosteriorToothPlan plan_;
    SectionLoft crown_;
    OcclusalSurface table_;
    std::vector<SectionLoft> roots_, canals_;
    double deepestGroove_ = 0;                           // mm: depth of the deepest groove with its pits
    double highestBuccally_ = 0, highestLingually_ = 0;  // heights of the highest cusps
};

double canalDistance(const SectionLoft& loft, const Vec3& p, double end) {
    return std::max(smoothIntersection(loft(p), end - p.z(), 0.15), p.z() - 0.3);
}

/// The chamber, a horn under each cusp, and the root canals.
double PosteriorTooth::pulp(const Vec3& p) const {
    const double round = plan_.chamberRound;
    const Vec3 out = (p - plan_.chamber).cwiseAbs() - (plan_.chamberHalf - Vec3::Constant(round));
    double chamber = out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0) - round;
    for (const Cusp& cusp : plan_.cusps) {
        const Vec3 base(0.62 * cusp.x, 0.46 * cusp.y, 0.4), tip(0.72 * cusp.x, 0.56 * cusp.y, cusp.z - plan_.hornRise);
        chamber = smoothUnion(chamber, taperedCapsule(p, base, plan_.hornBase, tip, 0.15), 0.5);
    }
    double canals = canalDistance(canals_[0], p, plan_.canals[0][0].z);
    for (std::size_t i = 1; i < canals_.size(); ++i) {
        canals = std::min(canals, canalDistance(canals_[i], p, plan_.canals[i][0].z));
    }
    return smoothUnion(chamber, canals, 0.4);
}

}  // namespace

void addRoot(PosteriorToothPlan& plan, const RootForm& form, std::initializer_list<CanalForm> canals,
             double concavity) {
    plan.roots.push_back({rootSections(form), -form.length - 0.05, concavity, form.bendY, 1 - form.length});
    for (const CanalForm& canal : canals) plan.canals.push_back(canalSections(form, canal));
}

ToothShape posteriorTooth(const PosteriorToothPlan& plan) {
    TACTOOTH_ASSERT(!plan.pits.empty() && !plan.cusps.empty() && !plan.roots.empty());
    TACTOOTH_ASSERT(plan.enamel > 0);
    TACTOOTH_ASSERT(!plan.bounds.isEmpty());
    const auto tooth = std::make_shared<const PosteriorTooth>(plan);
    const OcclusalPit& pit = plan.pits.front();
    ToothShape shape;
    shape.name = plan.name;
    shape.fdi = plan.fdi;
    shape.bounds = plan.bounds;
    shape.outer = [tooth](const Vec3& p) { return tooth->outer(p); };
    shape.core = [tooth](const Vec3& p) { return tooth->core(p); };
    shape.cervical = [tooth](const Vec3& p) { return tooth->cervical(p); };
    shape.pulp = [tooth](const Vec3& p) { return tooth->pulp(p); };
    shape.lesionSite = tooth->occlusalPlace(pit.x, pit.y);
    shape.lesionInward = -Vec3::UnitZ();
    shape.lesionEnamel = 0.9;
    return shape;
}

}  // namespace tactooth

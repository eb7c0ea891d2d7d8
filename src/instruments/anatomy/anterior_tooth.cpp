// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/anatomy/anterior_tooth.h"

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

class AnteriorTooth {
public:
    explicit AnteriorTooth(AnteriorToothPlan plan)
        : plan_(std::move(plan)), body_(centred(plan_.body)), pulp_(plan_.pulp) {}

    [[nodiscard]] double outer(const Vec3& p) const {
        constexpr double kApexBlend = 0.8, kEdgeBlend = 0.5;
        const double withApex = smoothIntersection(sides(p), plan_.apex - p.z(), kApexBlend);
        return smoothIntersection(withApex, edge(p), kEdgeBlend);
    }

    [[nodiscard]] double core(const Vec3& p) const {
        const double height = cervical(p), surface = outer(p);
        if (height <= 0) return surface;
        constexpr double kFeather = 1.6;  // mm over which the enamel grows from its thin edge
        const double thickness = plan_.enamelThickness * (1 - std::exp(-height / kFeather));
        return smoothIntersection(surface + thickness, edge(p) + plan_.incisalEnamel, 0.6);
    }

    [[nodiscard]] double cervical(const Vec3& p) const {
        const double part = p.x() / plan_.cervicalHalfWidth;
        return p.z() - (p.x() > 0 ? plan_.mesialRise : plan_.distalRise) * part * part;
    }

    [[nodiscard]] double pulp(const Vec3& p) const {
        constexpr double kBlend = 0.3;
        const double canal = smoothIntersection(pulp_(p), plan_.pulp.front().z - p.z(), kBlend);
        return smoothIntersection(canal, p.z() - plan_.pulp.back().z, kBlend);
    }

private:
    [[nodiscard]] double sides(const Vec3& p) const {
        double distance = body_(p);
        for (const FaceGroove& f : p.y() > body_.at(p.z()).y ? plan_.labial : plan_.lingual) distance += depthOf(f, p);
        constexpr double kStep = 0.07;  // mm that the crown protrudes over the root
        return distance + kStep * (1 - smoothStep(-0.15, 0.35, cervical(p)));
    }

    [[nodiscard]] double depthOf(const FaceGroove& f, const Vec3& p) const {
        const Section section = body_.at(p.z());
        // So that neither face gets the grooves of the other.
        const double fromMiddle = std::abs(p.y() - section.y) / section.plusY;
        constexpr double kFade = 1.5;  // mm above and below
        return f.depth * bump(p.x() - f.x, f.width) * smoothStep(f.from - kFade, f.from, p.z()) *
               smoothStep(f.to + kFade, f.to, p.z()) * smoothStep(0.0, 0.6, fromMiddle);
    }

    [[nodiscard]] double edge(const Vec3& p) const {
        const double aside = p.x() - plan_.edgeX, slope = aside > 0 ? plan_.mesialEdgeSlope : plan_.distalEdgeSlope;
        const double round = plan_.edgeRoundness;
        const double fall = slope * (std::sqrt(aside * aside + round * round) - round);
        const Section top = body_.at(plan_.edgeZ);
        const double lingually = top.y + top.plusY - p.y();
        const double height = p.z() - plan_.edgeZ + fall + plan_.bevel * lingually;
        return height / std::sqrt(1 + slope * slope + plan_.bevel * plan_.bevel);
    }

    AnteriorToothPlan plan_;
    SectionLoft body_, pulp_;
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

AnteriorToothPlan resized(AnteriorToothPlan plan, const AnteriorToothSize& from, const AnteriorToothSize& to,
                          std::string name, int fdi) {
    TACTOOTH_ASSERT(from.crown > 0 && from.root > 0);
    TACTOOTH_ASSERT(to.crown > 0 && to.root > 0);
    plan.name = std::move(name);
    plan.fdi = fdi;
    const double crown = to.crown / from.crown, root = to.root / from.root;
    const double cervixX = to.cervixMesiodistal / from.cervixMesiodistal, wideX = to.mesiodistal / from.mesiodistal;
    const double cervixY = to.cervixLabiolingual / from.cervixLabiolingual, wideY = to.labiolingual / from.labiolingual;
    // Mesiodistally an anterior tooth is widest near its edge, labiolingually just above its neck.
    constexpr double kWideX = 0.6, kWideY = 0.15;  // of the crown's length
    const auto alongX = [&](double z) { return std::lerp(cervixX, wideX, smoothStep(0, kWideX * from.crown, z)); };
    const auto alongY = [&](double z) { return std::lerp(cervixY, wideY, smoothStep(0, kWideY * from.crown, z)); };
    const auto resize = [&](Section& s) {
        const double x = alongX(s.z), y = alongY(s.z);
        s = {s.z * (s.z > 0 ? crown : root),
             x * s.plusX,
             x * s.minusX,
             y * s.plusY,
             y * s.minusY,
             s.squareness,
             x * s.x,
             y * s.y};
    };
    for (Section& s : plan.body) resize(s);
    for (Section& s : plan.pulp) resize(s);
    for (std::vector<FaceGroove>* furrows : {&plan.labial, &plan.lingual}) {
        for (FaceGroove& f : *furrows)
            f = {f.x * wideX, f.width * wideX, f.from * crown, f.to * crown, f.depth * wideX};
    }
    plan.apex *= root;
    plan.edgeX *= wideX;
    plan.edgeZ *= crown;
    plan.edgeRoundness *= wideX;
    plan.cervicalHalfWidth *= cervixX;
    for (Vec3* point : {&plan.lesionFrom, &plan.lesionToward}) {
        *point = point->cwiseProduct(Vec3(alongX(point->z()), alongY(point->z()), crown));
    }
    return plan;
}

ToothShape anteriorTooth(const AnteriorToothPlan& plan) {
    TACTOOTH_ASSERT(plan.enamelThickness > 0 && plan.incisalEnamel > 0);
    TACTOOTH_ASSERT(plan.apex < 0 && plan.edgeZ > 0);
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
    shape.lesionEnamel = plan.enamelThickness * 0.8;
    return shape;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>

namespace tactooth {
namespace {

using std::numbers::pi;

/// One ring of vertices around the axis.
struct Ring {
    double z = 0;
    double radius = 0;       ///< of the surface of revolution, where the blade edges are
    double gulletDepth = 0;  ///< depth of the gullets between the blades, as a part of the radius
    double twist = 0;        ///< turn of the blades, rad
};

/// A corner of the section of one blade: where it lies within the blade's share of the turn (0: edge, toward 1: the
/// foot of the next blade's rake face), and how far down the gullet it is (0: edge, 1: bottom).
struct BladeCorner {
    double turn = 0;
    double drop = 0;
};

// A bur turns clockwise seen from the handpiece, that is toward falling angles: the rake face is steep and lies before
// the edge; behind it the clearance falls slowly into the gullet.
constexpr BladeCorner kBlade2[] = {{0, 0}, {0.84, 1}};
constexpr BladeCorner kBlade3[] = {{0, 0}, {0.30, 0.42}, {0.84, 1}};
constexpr BladeCorner kBlade6[] = {{0, 0}, {0.10, 0.10}, {0.30, 0.45}, {0.55, 0.88}, {0.78, 1}, {0.90, 0.80}};

constexpr double kGulletDepth = 0.30;          // of the radius: a carbide's core is about two thirds of its head
constexpr double kRoundTwist = 0.9;            // rad from tip to neck of a ball
constexpr double kHelixAngle = 15 * pi / 180;  // of a fissure bur's blades, right-handed: lifts the chips
constexpr double kNeckPart = 0.62;             // neck radius as a part of the head's end radius
constexpr double kNeckLength = 1.2;            // mm, from the head to where the neck begins to widen
constexpr double kNeckAngle = 12 * pi / 180;   // half angle of the cone from neck to shank
constexpr double kVisibleLength = 11.0;        // mm from the tip to the end that is hidden in the handpiece
[[maybe_unused]] constexpr double kLongestHead = 8.5;  // mm; longer heads would end in the handpiece

std::span<const BladeCorner> bladeSection(int triangles) {
    constexpr int kCoarse = 700;  // below it, each triangle is needed along the axis
    constexpr int kMiddle = 2500;
    if (triangles < kCoarse) return kBlade2;
    if (triangles < kMiddle) return kBlade3;
    return kBlade6;
}

/// The arc that ends a head: an ellipse around the axis from the tip over `angle` (beyond pi/2: past the equator).
struct Cap {
    double radius = 0;
    double height = 0;
    double angle = pi / 2;
};

double headEndRadius(const BurSpec& spec) {
    const double radius = spec.headDiameter / 2;
    if (spec.kind == BurKind::round) return kNeckPart * radius;
    const double slope = std::tan(spec.taperDegrees * pi / 360);
    return slope < 0 ? radius + slope * spec.headLength : radius;
}

Cap capOf(const BurSpec& spec) {
    const double radius = spec.headDiameter / 2;
    switch (spec.kind) {
        case BurKind::round:
            return {radius, radius, pi - std::asin(kNeckPart)};
        case BurKind::straightFissure:
            return {radius, 0, pi / 2};
        case BurKind::pear:
            return {radius, 0.8 * radius, pi / 2};  // flatter than a ball, as a pear's end is
        case BurKind::roundEndTaper:
            break;
    }
    const double slope = std::tan(spec.taperDegrees * pi / 360);
    const double tip = (radius - slope * spec.headLength) / (1 - slope);
    return {tip, tip, pi / 2};
}

/// Rings over the cap. Its widest place is always one of them, so that the head has its exact diameter.
void addCapRings(std::vector<Ring>& rings, const Cap& cap, int count) {
    const auto ringAt = [&](double angle) {
        rings.push_back({cap.height * (1 - std::cos(angle)), cap.radius * std::sin(angle)});
    };
    const int toEquator = std::max(1, static_cast<int>(std::lround(count * (pi / 2) / cap.angle)));
    for (int i = 1; i <= toEquator; ++i) ringAt(pi / 2 * i / toEquator);
    for (int i = 1; i <= count - toEquator; ++i) {
        ringAt(pi / 2 + (cap.angle - pi / 2) * i / (count - toEquator));
    }
}

void addSideRings(std::vector<Ring>& rings, double headLength, double endRadius, int count) {
    const Ring from = rings.back();
    for (int i = 1; i <= count; ++i) {
        const double part = static_cast<double>(i) / count;
        rings.push_back({std::lerp(from.z, headLength, part), std::lerp(from.radius, endRadius, part)});
    }
}

/// Gullets run out toward the end of the head, and the blades wind around it.
void cutBlades(std::vector<Ring>& rings, const BurSpec& spec) {
    if (spec.flutes == 0) return;
    const double end = rings.back().z;
    const double twistPerLength =
        spec.kind == BurKind::round ? kRoundTwist / spec.headDiameter : std::tan(kHelixAngle) / (spec.headDiameter / 2);
    for (Ring& ring : rings) {
        constexpr double kRunOut = 0.2;  // of the head's length
        const double left = std::clamp((end - ring.z) / (kRunOut * end), 0.0, 1.0);
        ring.gulletDepth = kGulletDepth * std::sqrt(left);
        ring.twist = twistPerLength * ring.z;
    }
}

std::vector<Ring> headRings(const BurSpec& spec, int count) {
    std::vector<Ring> rings;
    const Cap cap = capOf(spec);
    if (spec.kind == BurKind::round) {
        addCapRings(rings, cap, count);
    } else {
        const double arc = cap.height > 0 ? (cap.height + cap.radius) / 1.3 : 0;  // near enough to share out the rings
        const double side = spec.headLength - cap.height;
        const int capRings =
            cap.height > 0 ? std::clamp(static_cast<int>(std::lround(count * arc / (arc + side))), 2, count - 2) : 1;
        addCapRings(rings, cap, capRings);
        addSideRings(rings, spec.headLength, headEndRadius(spec), count - capRings);
    }
    cutBlades(rings, spec);
    return rings;
}

constexpr int kShaftRings = 4;

/// Neck and shank, behind a head that ends with `head`.
void addShaftRings(std::vector<Ring>& rings, const BurSpec& spec) {
    const Ring head = rings.back();
    const double shank = kShankDiameter / 2;
    const double neck = spec.kind == BurKind::round ? head.radius * 0.95 : std::min(head.radius * 0.8, shank);
    const double shoulder = head.z + std::abs(head.radius - neck) + 0.1;
    const double neckEnd = shoulder + (spec.kind == BurKind::round ? kNeckLength : kNeckLength / 2);
    const double shankStart = std::min(neckEnd + (shank - neck) / std::tan(kNeckAngle), kVisibleLength - 1);
    const double twist = head.twist;
    rings.push_back({shoulder, neck, 0, twist});
    rings.push_back({neckEnd, neck, 0, twist});
    rings.push_back({shankStart, shank, 0, twist});
    rings.push_back({kVisibleLength, shank, 0, twist});
}

class Lathe {
public:
    Lathe(int flutes, std::span<const BladeCorner> blade) : flutes_(flutes), blade_(blade) {}

    [[nodiscard]] int sectors() const { return flutes_ * static_cast<int>(blade_.size()); }

    [[nodiscard]] TriangleMesh turn(const std::vector<Ring>& rings) const {
        TriangleMesh mesh;
        mesh.vertices.emplace_back(0.f, 0.f, 0.f);
        for (const Ring& ring : rings) addRing(mesh, ring);
        mesh.vertices.push_back(Vec3(0, 0, rings.back().z).cast<float>());
        const int last = static_cast<int>(rings.size()) - 1;
        for (int sector = 0; sector < sectors(); ++sector) {
            mesh.triangles.push_back({0, at(0, sector + 1), at(0, sector)});
            for (int ring = 0; ring < last; ++ring) addQuad(mesh, ring, sector);
            mesh.triangles.push_back(
                {static_cast<std::uint32_t>(mesh.vertices.size() - 1), at(last, sector), at(last, sector + 1)});
        }
        return mesh;
    }

private:
    [[nodiscard]] std::uint32_t at(int ring, int sector) const {
        return static_cast<std::uint32_t>(1 + ring * sectors() + sector % sectors());
    }

    void addRing(TriangleMesh& mesh, const Ring& ring) const {
        const auto corners = static_cast<int>(blade_.size());
        for (int sector = 0; sector < sectors(); ++sector) {
            const BladeCorner& corner = blade_[sector % corners];
            // Without gullets the vertices stand evenly, for the roundest neck and shank.
            const double even = static_cast<double>(sector % corners) / corners;
            const double turn = std::lerp(even, corner.turn, ring.gulletDepth / kGulletDepth);
            const double angle = 2 * pi * (sector / corners + turn) / flutes_ + ring.twist;
            const double radius = ring.radius * (1 - ring.gulletDepth * corner.drop);
            mesh.vertices.push_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), ring.z).cast<float>());
        }
    }

    /// Two triangles, split along the shorter diagonal: the blades wind.
    void addQuad(TriangleMesh& mesh, int ring, int sector) const {
        const std::uint32_t a = at(ring, sector), b = at(ring, sector + 1);
        const std::uint32_t c = at(ring + 1, sector + 1), d = at(ring + 1, sector);
        const auto length = [&](std::uint32_t from, std::uint32_t to) {
            return (mesh.vertices[from] - mesh.vertices[to]).norm();
        };
        if (length(a, c) <= length(b, d)) {
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        } else {
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({b, c, d});
        }
    }

    int flutes_;
    std::span<const BladeCorner> blade_;
};

}  // namespace

Bur makeBur(const BurSpec& spec, int triangles) {
    assert(spec.headDiameter > 0 && spec.headLength > 0 && spec.headLength <= kLongestHead);
    constexpr int kSmoothFlutes = 6;  // a diamond is as round as the vertices of a six-blade bur make it
    const Lathe lathe(spec.flutes > 0 ? spec.flutes : kSmoothFlutes, bladeSection(triangles));
    constexpr int kFewestHeadRings = 5;
    const int rings = std::max(kFewestHeadRings, triangles / (2 * lathe.sectors()) - kShaftRings);
    std::vector<Ring> outline = headRings(spec, rings);
    addShaftRings(outline, spec);
    return {spec, lathe.turn(outline)};
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "geometry/util/assert.h"
#include "instruments/bur_outline.h"

namespace tactooth {
namespace {

using std::numbers::pi;

/// One ring of vertices around the axis.
struct Ring {
    double z = 0;
    double radius = 0;       ///< of the surface of revolution, where the blade edges are
    double gulletDepth = 0;  ///< depth of the gullets between the blades, as a share of the radius
    double twist = 0;        ///< rotation of the blades, rad
    int notched = -1;        ///< 0: every second blade has a notch here, 1: the others, -1: none
    double grain = 0;        ///< mm between the highest and the lowest grain of a diamond
};

/// A corner of the section of one blade: its position in the blade's share of the turn (0: edge, toward 1: the foot of
/// the next blade's rake face), and its depth in the gullet (0: edge, 1: bottom).
struct BladeVertex {
    double turn = 0;
    double drop = 0;
};

// A bur turns clockwise seen from the handpiece, that is toward falling angles: the rake face is steep and in front of
// the edge; behind the edge the clearance falls slowly into the gullet.
constexpr BladeVertex kBlade2[] = {{0, 0}, {0.84, 1}};
constexpr BladeVertex kBlade3[] = {{0, 0}, {0.30, 0.42}, {0.84, 1}};
constexpr BladeVertex kBlade6[] = {{0, 0}, {0.10, 0.10}, {0.30, 0.45}, {0.55, 0.88}, {0.78, 1}, {0.90, 0.80}};

constexpr double kGulletDepth = 0.30;  // share of the radius: the core of a carbide bur is about two thirds of its head
constexpr double kFinishingDepth = 0.12;       // share of the radius, for the many small gullets of a finishing bur
constexpr int kManyBlades = 12;                // a finishing bur
constexpr double kNotchDepth = 0.10;           // share of the radius, for the notches of a cross-cut blade
constexpr double kRoundTwist = 0.9;            // rad from tip to neck of a ball
constexpr double kMaxTwist = 0.12;             // rad from ring to ring: edges sink below the outline by 0.2 % at most
constexpr double kHelixAngle = 15 * pi / 180;  // of a fissure bur's blades, right-handed: lifts the chips
constexpr double kNeckPart = 0.62;             // neck radius of a ball as a part of its radius
constexpr double kNeckLength = 1.2;            // mm, from the head to where the neck begins to widen
constexpr double kNeckAngle = 12 * pi / 180;   // half angle of the cone from neck to shank
constexpr double kVisibleLength = 11.0;        // mm from the tip to the end that is hidden in the handpiece
[[maybe_unused]] constexpr double kMaxHeadLength = 8.5;  // mm; longer heads would end in the handpiece

constexpr int kCoarse = 700;  // triangles: below this number, each is needed along the axis

std::span<const BladeVertex> bladeSection(int triangles) {
    constexpr int kMiddle = 2500;
    if (triangles < kCoarse) return kBlade2;
    if (triangles < kMiddle) return kBlade3;
    return kBlade6;
}

double longestStep(const std::vector<Ring>& rings) {
    double step = 0;
    for (std::size_t i = 1; i < rings.size(); ++i) step = std::max(step, rings[i].z - rings[i - 1].z);
    return step;
}

/// Gullets fade toward the end of the head, and the blades are helical.
void cutBlades(std::vector<Ring>& rings, const BurSpec& spec) {
    const double end = rings.back().z;
    const double helix =
        spec.kind == BurKind::Round ? kRoundTwist / spec.headDiameter : std::tan(kHelixAngle) / (spec.headDiameter / 2);
    const double twistPerLength = std::min(helix, kMaxTwist / std::max(longestStep(rings), 1e-6));
    for (Ring& ring : rings) {
        constexpr double kRunOut = 0.2;  // of the head's length
        const double left = std::clamp((end - ring.z) / (kRunOut * end), 0.0, 1.0);
        ring.gulletDepth = (spec.flutes >= kManyBlades ? kFinishingDepth : kGulletDepth) * std::sqrt(left);
        ring.twist = twistPerLength * ring.z;
    }
}

/// Notches of a cross-cut bur, if the rings are close enough to show them. Neighbouring blades have them at different
/// heights, so that together they still sweep the whole outline.
void cutNotches(std::vector<Ring>& rings) {
    constexpr double kFineEnough = 0.12, kSpacing = 0.45;  // mm; between the notches of a blade
    const double step = longestStep(rings);
    if (step > kFineEnough) return;
    const auto half = static_cast<std::size_t>(std::max(2L, std::lround(kSpacing / step / 2)));  // in rings
    for (std::size_t i = half; i + half < rings.size(); ++i) {
        const std::size_t place = i % half;  // the middle third of a half spacing is notched
        if (3 * place >= half && 3 * place < 2 * half) rings[i].notched = static_cast<int>(i / half % 2);
    }
}

/// Grains of a diamond, if the triangles are small enough to show them.
void setGrains(std::vector<Ring>& rings, const BurSpec& spec, int sectors) {
    constexpr double kMillimetres = 1e-3;  // in a micrometre
    constexpr double kExposed = 0.4;       // of a grain, above the bond
    const double grit = kMillimetres * spec.gritMicrometres, fineEnough = 1.5 * grit;
    const double side = pi * spec.headDiameter / sectors;
    if (std::max(side, longestStep(rings)) > fineEnough) return;
    for (Ring& ring : rings) ring.grain = std::min(kExposed * grit, 0.2 * ring.radius);
}

std::vector<Ring> headRings(const BurSpec& spec, int count, int sectors) {
    std::vector<Ring> rings;
    for (const auto& [radius, z] : burOutline(spec, count)) rings.push_back({.z = z, .radius = radius});
    if (spec.flutes > 0) cutBlades(rings, spec);
    if (spec.crossCut) cutNotches(rings);
    if (spec.gritMicrometres > 0) setGrains(rings, spec, sectors);
    return rings;
}

/// A pseudorandom number from 0 to 1, the same for the same grain.
double grainDepth(int ring, int sector) {
    std::uint32_t bits =
        0x9E3779B9u * static_cast<std::uint32_t>(ring + 1) ^ 0x85EBCA6Bu * static_cast<std::uint32_t>(sector + 1);
    bits = (bits ^ bits >> 15) * 0x2C1B3C6Du;
    bits = (bits ^ bits >> 12) * 0x297A2D39u;
    return static_cast<double>((bits ^ bits >> 15) & 0xFFFFu) / 0xFFFF;
}

constexpr int kShaftRings = 4;

/// Neck and shank, behind a head that ends with `head`.
void addShaftRings(std::vector<Ring>& rings, const BurSpec& spec) {
    const Ring head = rings.back();
    const double shank = kShankDiameter / 2;
    const double neck = spec.kind == BurKind::Round ? std::min(kNeckPart * spec.headDiameter / 2, shank)
                                                    : std::min(head.radius * 0.8, shank);
    const double shoulder = spec.kind == BurKind::Wheel ? head.z + 0.02 : head.z + std::abs(head.radius - neck) + 0.1;
    const double neckEnd = shoulder + (spec.kind == BurKind::Round ? kNeckLength : kNeckLength / 2);
    const double shankStart = std::min(neckEnd + 0.1 + (shank - neck) / std::tan(kNeckAngle), kVisibleLength - 1);
    const double twist = head.twist;
    for (const auto& [z, radius] : {std::pair(shoulder, neck), std::pair(neckEnd, neck), std::pair(shankStart, shank),
                                    std::pair(kVisibleLength, shank)}) {
        rings.push_back({.z = z, .radius = radius, .twist = twist});
    }
}

class Lathe {
public:
    Lathe(int flutes, std::span<const BladeVertex> blade) : flutes_(flutes), blade_(blade) {}

    [[nodiscard]] int sectors() const { return flutes_ * static_cast<int>(blade_.size()); }

    [[nodiscard]] TriangleMesh turn(const std::vector<Ring>& rings) const {
        TriangleMesh mesh;
        mesh.vertices.emplace_back(0.f, 0.f, 0.f);
        for (int ring = 0; ring < static_cast<int>(rings.size()); ++ring) addRing(mesh, rings[ring], ring);
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

    void addRing(TriangleMesh& mesh, const Ring& ring, int number) const {
        const auto corners = static_cast<int>(blade_.size());
        const double bladed = std::min(ring.gulletDepth / kFinishingDepth, 1.0);
        for (int sector = 0; sector < sectors(); ++sector) {
            const BladeVertex& corner = blade_[sector % corners];
            // Without gullets the vertices are evenly spaced, for the roundest neck and shank.
            const double even = static_cast<double>(sector % corners) / corners;
            const double turn = std::lerp(even, corner.turn, bladed);
            const double angle = 2 * pi * (sector / corners + turn) / flutes_ + ring.twist;
            const bool notched = sector / corners % 2 == ring.notched;
            const double drop = std::max(ring.gulletDepth * corner.drop, notched ? kNotchDepth : 0.0);
            // One row of grains is as high as the outline: it is the profile that the turning bur sweeps.
            const double grain = sector == 0 ? 0 : ring.grain * grainDepth(number, sector);
            const double radius = ring.radius * (1 - drop) - grain;
            mesh.vertices.push_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), ring.z).cast<float>());
        }
    }

    /// Two triangles, split along the shorter diagonal, because the blades are helical.
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
    std::span<const BladeVertex> blade_;
};

/// The number of repetitions of the pattern around the axis.
Lathe latheFor(const BurSpec& spec, int triangles) {
    constexpr int kFine = 8000;
    constexpr int kSmooth = 6;         // a diamond is as round as a six-blade bur
    constexpr int kBladesShown = 700;  // least number of triangles for many blades
    const bool bladed = spec.flutes > 0 && (spec.flutes < kManyBlades || triangles >= kBladesShown);
    const int blades = triangles < kCoarse && spec.contactFlutes > 0 ? spec.contactFlutes : spec.flutes;
    const int around = bladed ? blades : triangles < kFine ? kSmooth : 2 * kSmooth;
    return {around, bladeSection(spec.flutes < kManyBlades ? triangles : triangles / 2)};
}

/// Inserts a vertex in the middle of an edge: two triangles more, and the same surface.
void splitEdge(TriangleMesh& mesh, std::uint32_t from, std::uint32_t to) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back((mesh.vertices[from] + mesh.vertices[to]) / 2);
    const std::size_t before = mesh.triangles.size();
    for (std::size_t i = 0; i < before; ++i) {
        Triangle& triangle = mesh.triangles[i];
        const auto atFrom = std::ranges::find(triangle, from), atTo = std::ranges::find(triangle, to);
        if (atFrom == triangle.end() || atTo == triangle.end()) continue;
        Triangle half = triangle;
        half[static_cast<std::size_t>(atFrom - triangle.begin())] = middle;
        *atTo = middle;
        mesh.triangles.push_back(half);
    }
    TACTOOTH_ASSERT(mesh.triangles.size() == before + 2);
}

}  // namespace

Bur makeBurWithTriangles(const BurSpec& spec, int triangles) {
    Bur bur = makeBur(spec, triangles);
    TriangleMesh& mesh = bur.surface;
    const auto around = static_cast<std::uint32_t>(latheFor(spec, triangles).sectors());
    const auto end = static_cast<std::uint32_t>(mesh.vertices.size() - 1);  // the pole; the last ring is before it
    const auto wanted = static_cast<std::size_t>(triangles);
    for (std::uint32_t sector = 0; mesh.triangles.size() + 2 <= wanted; sector = (sector + 1) % around) {
        const std::uint32_t onEnd = end - around + sector;
        splitEdge(mesh, onEnd - around, onEnd);  // straight along the shank
    }
    return bur;
}

Bur makeBur(const BurSpec& spec, int triangles) {
    TACTOOTH_ASSERT(spec.headDiameter > 0 && spec.headLength > 0 && spec.headLength <= kMaxHeadLength);
    const Lathe lathe = latheFor(spec, triangles);
    constexpr int kMinHeadRings = 5;
    const int rings = std::max(kMinHeadRings, triangles / (2 * lathe.sectors()) - kShaftRings);
    std::vector<Ring> outline = headRings(spec, rings, lathe.sectors());
    addShaftRings(outline, spec);
    return {spec, lathe.turn(outline)};
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_mouth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/solid/self_intersection_repair.h"
#include "geometry/field/isosurface.h"
#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "geometry/util/disjoint_sets.h"
#include "geometry/util/parallel_for.h"
#include "instruments/messages.h"
#include "instruments/mouth/gingiva.h"
#include "instruments/mouth/tooth_arrangement.h"
#include "instruments/mouth/valid_gingiva.h"
#include "instruments/mouth_layout.h"

namespace tactooth {
namespace {

/// The triangles of the gingiva are longer than those of the teeth, between what its thin margins need and what is
/// useful.
double gingivaCell(int triangles) {
    constexpr double kOf20000 = 0.4, kFinest = 0.2, kCoarsest = 0.4;  // mm
    return std::clamp(kOf20000 * std::sqrt(20000.0 / triangles), kFinest, kCoarsest);
}

/// The component with the most triangles: small components between two roots are not gingiva.
TriangleMesh largestPiece(const TriangleMesh& mesh) {
    DisjointSets pieces(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles) {
        pieces.join(t[0], t[1]);
        pieces.join(t[0], t[2]);
    }
    std::vector<std::size_t> triangles(mesh.vertices.size(), 0);
    for (const Triangle& t : mesh.triangles) ++triangles[pieces.find(t[0])];
    const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(triangles) - triangles.begin());
    TriangleMesh piece;
    std::vector<std::uint32_t> renumbered(mesh.vertices.size());
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        renumbered[i] = static_cast<std::uint32_t>(piece.vertices.size());
        if (pieces.find(i) == largest) piece.vertices.push_back(mesh.vertices[i]);
    }
    for (const Triangle& t : mesh.triangles) {
        if (pieces.find(t[0]) == largest)
            piece.triangles.push_back({renumbered[t[0]], renumbered[t[1]], renumbered[t[2]]});
    }
    return piece;
}

/// Away from the margins heights are stretched by up to this factor: longer triangles, and fewer.
constexpr double kStretch = 2.5, kOnset = 3;
constexpr double kMaxSlope = 1.6;

Vec3 stretched(const GingivaBody& body, bool upper, const Vec3& p) {
    const double up = upper ? -1 : 1;
    const double below = body.smoothBelow - up * p.z();
    if (below <= 0) return p;
    return {p.x(), p.y(), p.z() - up * (kStretch - 1) * below * below / (below + kOnset)};
}

RelaxedSurface gingivaSurface(const GingivaBody& body, const ScalarField& of, bool upper, double cell) {
    const auto field = [&](const Vec3& p) { return of(stretched(body, upper, p)); };
    RelaxedSurface surface = relaxedIsosurface(field, body.bounds, {cell, kMaxSlope * kStretch});
    for (auto* vertices : {&surface.mesh.vertices, &surface.restPositions}) {
        for (Vec3f& vertex : *vertices) vertex = stretched(body, upper, vertex.cast<double>()).cast<float>();
    }
    return surface;
}

GingivaCandidate gingivaMesh(const GingivaBody& body, bool upper, double cell) {
    RelaxedSurface surface = gingivaSurface(body, body.field, upper, cell);
    const bool repaired = repairSelfIntersections(surface.mesh, surface.restPositions);
    return {largestPiece(surface.mesh), !repaired};
}

ZonedMesh shownGingiva(const GingivaBody& body, bool upper, const MouthRequest& request) {
    ZonedMesh shown;
    shown.mesh = largestPiece(gingivaSurface(body, body.shown, upper, gingivaCell(request.triangles)).mesh);
    shown.zones.resize(shown.mesh.vertices.size());
    parallelFor(shown.zones.size(), [&](std::size_t i) {
        shown.zones[i] = ZonedMesh::zoneOf(body.zone(shown.mesh.vertices[i].cast<double>()));
    });
    return shown;
}

Expected<TriangleMesh> gingivaOf(const GingivaBody& body, bool upper, const MouthRequest& request) {
    return firstValidGingiva(gingivaCell(request.triangles),
                             [&](double cell) { return gingivaMesh(body, upper, cell); },
                             {upper ? msg::kUpperGingiva : msg::kLowerGingiva, request.seed, request.triangles});
}

/// Position in a dental chart: 18 to 28 above, 38 to 48 below.
int chartPlace(int fdi) {
    const int quadrant = fdi / 10, place = fdi % 10;
    constexpr std::array<int, 5> kFirst = {0, 0, 8, 16, 24};
    const int at = quadrant == 1 || quadrant == 3 ? 8 - place : place - 1;
    return kFirst[static_cast<std::size_t>(quadrant)] + at;
}

}  // namespace

const MouthTooth* BuiltinMouth::find(int fdi) const {
    const auto found = std::ranges::find(teeth, fdi, [](const MouthTooth& one) { return one.tooth.fdi; });
    return found != teeth.end() ? &*found : nullptr;
}

std::vector<SoftTissue> softTissuesOf(const BuiltinMouth& mouth, int worked) {
    if (mouth.jaw == JawPose::Closed) return {};
    return makeSoftTissues(mouth.sideInMouth, mouth.lowerJaw, worked);
}

Pose lowerJawPose(JawPose jaw) {
    if (jaw == JawPose::Closed) return {};
    // Between the condyles: Bonwill's triangle of four inches, and 35 mm above the occlusal plane.
    const Vec3 hinge(0, -88, 35);
    constexpr double kOpening = 0.507;  // rad: 40 mm between the edges, a usual opening for treatment
    const Vec3 slide(0, 5, -3);         // mm that the condyles move forward and down when the mouth opens
    const Quat turn(Eigen::AngleAxisd(-kOpening, Vec3::UnitX()));
    return {hinge + slide - turn * hinge, turn};
}

Expected<MouthLayout> makeMouthLayout(const MouthRequest& request) {
    TACTOOTH_ASSERT(request.triangles > 0);
    const ToothArrangement places = arrangeTeeth(request.seed);
    MouthLayout layout;
    for (std::size_t i = 0; i < MouthLayout::kPlaces; ++i) {
        const JawQuadrant& side = i < kTeethPerQuadrant ? places.upper : places.lower;
        layout.toothInMouth[i] = side.teeth[i % kTeethPerQuadrant].shapeInMouth;
    }
    std::array<Expected<TriangleMesh>, 2> gums = {TriangleMesh(), TriangleMesh()};
    std::array<GingivaBody, 2> bodies;
    parallelFor(2, [&](std::size_t i) { bodies[i] = gingivaBody(places, i == 0, request.missing); });
    parallelFor(4, [&](std::size_t i) {
        const bool upper = i % 2 == 0;
        if (i < 2) {
            gums[i] = gingivaOf(bodies[i], upper, request);
        } else {
            (upper ? layout.upperShown : layout.lowerShown) = shownGingiva(bodies[i - 2], upper, request);
        }
    });
    for (const auto& gum : gums) {
        if (!gum) return Unexpected{gum.error()};
    }
    layout.upperGingiva = std::move(*gums[0]);
    layout.lowerGingiva = std::move(*gums[1]);
    return layout;
}

std::uint64_t mouthLayoutFingerprint(const MouthRequest& request) {
    constexpr std::uint32_t kModel = 7;  // increase it when the same request gives other poses or another gingiva
    ByteWriter facts;
    facts.put(kModel);
    facts.put(request.triangles);
    for (std::size_t i = 0; i < MouthLayout::kPlaces; ++i) {
        facts.put(toothFingerprint({fdiOfPlace(i), request.triangles, request.seed, {}}));
    }
    std::vector<int> missing = request.missing;
    std::ranges::sort(missing);
    for (const int fdi : missing) facts.put(fdi);
    return checksum(facts.bytes());
}

Expected<BuiltinMouth> makeMouth(const MouthRequest& request, const ToothGenerator& teeth,
                                 const LayoutGenerator& layout) {
    TACTOOTH_ASSERT(request.triangles > 0);
    TACTOOTH_ASSERT(std::ranges::all_of(request.missing, isPermanentTooth));
    std::array<BuiltinTooth, MouthLayout::kPlaces> made;
    Expected<MouthLayout> set = MouthLayout();
    parallelFor(made.size() + 1, [&](std::size_t i) {
        if (i == 0) {
            set = layout(request);
        } else {
            made[i - 1] = teeth({fdiOfPlace(i - 1), request.triangles, request.seed, {}});
        }
    });
    if (!set) return Unexpected{set.error()};
    BuiltinMouth mouth;
    mouth.upperGingiva = std::move(set->upperGingiva);
    mouth.lowerGingiva = std::move(set->lowerGingiva);
    mouth.upperShown = std::move(set->upperShown);
    mouth.lowerShown = std::move(set->lowerShown);
    mouth.lowerJaw = lowerJawPose(request.jaw);
    mouth.jaw = request.jaw;
    mouth.sideInMouth.assign(set->toothInMouth.begin(), set->toothInMouth.end());
    const auto put = [&](BuiltinTooth tooth, const Pose& pose) {
        const bool isMissing = std::ranges::find(request.missing, tooth.fdi) != request.missing.end();
        if (!isMissing) mouth.teeth.push_back({std::move(tooth), pose});
    };
    for (std::size_t i = 0; i < made.size(); ++i) {
        put(contralateral(made[i]), mirroredInX(set->toothInMouth[i]));
        put(std::move(made[i]), set->toothInMouth[i]);
    }
    std::ranges::sort(mouth.teeth, {}, [](const MouthTooth& one) { return chartPlace(one.tooth.fdi); });
    return mouth;
}

Expected<BuiltinMouth> makeMouth(const MouthRequest& request, const ToothGenerator& generator) {
    return makeMouth(request, generator, makeMouthLayout);
}

}  // namespace tactooth

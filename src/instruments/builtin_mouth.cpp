// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_mouth.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel_for.h"
#include "instruments/modelling/folds.h"
#include "instruments/mouth/gingiva.h"
#include "instruments/mouth/tooth_places.h"

namespace tactooth {
namespace {

/// A gum's triangles are longer than those of its teeth, within what its thin margins need and what is of use.
double gumCell(int triangles) {
    constexpr double kOf20000 = 0.45, kFinest = 0.2, kCoarsest = 0.45;  // mm
    return std::clamp(kOf20000 * std::sqrt(20000.0 / triangles), kFinest, kCoarsest);
}

/// Of all pieces the one with the most triangles: crumbs between two roots are no gum.
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

TriangleMesh gumMesh(const GingivaBody& body, bool upper, double cell) {
    const double up = upper ? -1 : 1;
    // Away from the margins heights are stretched, up to this many times: longer triangles, and fewer.
    constexpr double kStretch = 2.5, kOnset = 3;
    const auto stretched = [&](const Vec3& p) -> Vec3 {
        const double below = body.smoothBelow - up * p.z();
        if (below <= 0) return p;
        return {p.x(), p.y(), p.z() - up * (kStretch - 1) * below * below / (below + kOnset)};
    };
    constexpr double kSteepest = 1.6;
    const auto field = [&](const Vec3& p) { return body.field(stretched(p)); };
    TriangleMesh mesh = isosurface(field, body.bounds, {cell, kSteepest * kStretch});
    for (Vec3f& vertex : mesh.vertices) vertex = stretched(vertex.cast<double>()).cast<float>();
    return largestPiece(mesh);
}

TriangleMesh gumOf(const ToothPlaces& places, bool upper, const MouthRequest& request) {
    const GingivaBody body = gingivaBody(places, upper, request.missing);
    double cell = gumCell(request.triangles);
    TriangleMesh mesh = gumMesh(body, upper, cell);
    constexpr int kTries = 4;           // the tip of a papilla may be thinner than a cell
    constexpr double kSharpest = -0.85;  // cosine between normals: all of a gum is rounded
    for (int i = 1; i < kTries && isFolded(mesh, kSharpest); ++i) {
        cell *= 0.97;
        mesh = gumMesh(body, upper, cell);
    }
    return mesh;
}

struct Pair {
    int fdi = 0;  // of the side that has been placed
    Pose pose;
};

std::vector<Pair> pairsOf(const ToothPlaces& places) {
    std::vector<Pair> pairs;
    for (const JawSide* side : {&places.upper, &places.lower}) {
        for (int i = 0; i < kTeethOfSide; ++i) {
            pairs.push_back({(side->upper ? 11 : 31) + i, side->teeth[static_cast<std::size_t>(i)].shapeInMouth});
        }
    }
    return pairs;
}

/// Place in a dentist's chart: 18 to 28 above, 38 to 48 below.
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

Pose lowerJawPose(JawPose jaw) {
    if (jaw == JawPose::closed) return {};
    // Between the condyles: Bonwill's triangle of four inches, and 35 mm above the occlusal plane.
    const Vec3 hinge(0, -88, 35);
    constexpr double kOpening = 0.507;  // rad: 40 mm between the edges, a usual opening for work
    const Vec3 slide(0, 5, -3);         // mm that the condyles go forward and down as the mouth opens
    const Quat turn(Eigen::AngleAxisd(-kOpening, Vec3::UnitX()));
    return {hinge + slide - turn * hinge, turn};
}

TriangleMesh moved(TriangleMesh mesh, const Pose& pose) {
    for (Vec3f& vertex : mesh.vertices) vertex = (pose * vertex.cast<double>()).cast<float>();
    return mesh;
}

BuiltinMouth makeMouth(const MouthRequest& request, const ToothMaker& maker) {
    assert(request.triangles > 0);
    const ToothPlaces places = placeTeeth(request.seed);
    const std::vector<Pair> pairs = pairsOf(places);
    BuiltinMouth mouth;
    mouth.lowerJaw = lowerJawPose(request.jaw);
    std::array<std::optional<MouthTooth>, 32> teeth;
    const auto isWanted = [&](int fdi) { return std::ranges::find(request.missing, fdi) == request.missing.end(); };
    const auto put = [&](BuiltinTooth tooth, const Pose& pose) {
        if (!isWanted(tooth.fdi)) return;
        auto& place = teeth[static_cast<std::size_t>(chartPlace(tooth.fdi))];
        place = MouthTooth{std::move(tooth), pose};
    };
    parallelFor(pairs.size() + 2, [&](std::size_t i) {
        if (i < 2) {
            (i == 0 ? mouth.upperGingiva : mouth.lowerGingiva) = gumOf(places, i == 0, request);
            return;
        }
        const Pair& pair = pairs[i - 2];
        BuiltinTooth tooth = maker({pair.fdi, request.triangles, request.seed, {}});
        put(otherSide(tooth), mirroredInX(pair.pose));
        put(std::move(tooth), pair.pose);
    });
    for (auto& tooth : teeth) {
        if (tooth) mouth.teeth.push_back(std::move(*tooth));
    }
    return mouth;
}

}  // namespace tactooth

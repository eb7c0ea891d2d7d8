// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/builtin_tooth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "instruments/anatomy/filling_body.h"
#include "instruments/anatomy/lesion.h"
#include "instruments/anatomy/tooth_shape.h"
#include "instruments/modelling/fold_check.h"
#include "instruments/tooth_making.h"

namespace tactooth {
namespace {

int numberOf(BuiltinToothKind kind) {
    switch (kind) {
        case BuiltinToothKind::LowerFirstMolar:
            return 46;
        case BuiltinToothKind::UpperCentralIncisor:
            return 11;
        case BuiltinToothKind::UpperCanine:
            break;
    }
    return 13;
}

constexpr int kRelaxations = 3;
constexpr double kCanalCell = 0.14;  // mm: the narrowest canal is 0.25 mm wide

/// The root is smooth and mostly out of reach. Below the neck, heights are stretched by up to this factor, so that its
/// triangles are longer and more of them are left for the crown.
constexpr double kRootStretch = 1.9;

Vec3 stretched(const Vec3& p) {
    constexpr double kNeck = -0.8, kOnset = 2.0;  // mm: where the stretch begins, and the length of its onset
    const double below = kNeck - p.z();
    if (below <= 0) return p;
    return {p.x(), p.y(), p.z() - (kRootStretch - 1) * below * below / (below + kOnset)};
}

TriangleMesh meshOf(const ScalarField& body, const Box3& bounds, double cellSize, int relaxations) {
    const auto field = [&](const Vec3& p) { return body(stretched(p)); };
    constexpr double kMaxSlope = 1.3 * kRootStretch;
    TriangleMesh mesh = isosurface(field, bounds, {cellSize, kMaxSlope, relaxations});
    for (Vec3f& vertex : mesh.vertices) vertex = stretched(vertex.cast<double>()).cast<float>();
    return mesh;
}

/// The cell size that gives about as many triangles: a coarse mesh measures the surface.
double cellSizeFor(const ToothShape& shape, int triangles) {
    constexpr double kTrial = 0.6;
    const TriangleMesh trial = meshOf(shape.outer, shape.bounds, kTrial, 0);
    return kTrial * std::sqrt(static_cast<double>(trial.triangles.size()) / triangles);
}

/// The tooth of the other side of the mouth.
void mirror(TriangleMesh& mesh) {
    for (Vec3f& vertex : mesh.vertices) vertex.x() = -vertex.x();
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

void mirrorLayers(BuiltinTooth& tooth) {
    for (TriangleMesh* mesh : meshesOf(tooth)) mirror(*mesh);
}

constexpr int kTries = 5;            // the first one succeeds for nearly every tooth
constexpr double kFinerCell = 0.97;  // of the cell before

/// Narrow canals that meet may fold where a finer mesh does not.
TriangleMesh pulpOf(const ToothShape& shape, double cellSize) {
    double cell = std::min(cellSize, kCanalCell);
    TriangleMesh pulp = meshOf(shape.pulp, shape.bounds, cell, kRelaxations);
    for (int i = 1; i < kTries && hasFolds(pulp); ++i) {
        cell *= kFinerCell;
        pulp = meshOf(shape.pulp, shape.bounds, cell, kRelaxations);
    }
    return pulp;
}

/// The tooth's layers as meshes, with +x mesial. All on one grid, so that layers that share a surface share triangles.
BuiltinTooth meshed(const ToothShape& shape, double cellSize, const std::function<void(double)>& progress) {
    const auto report = [&](double share) {
        if (progress) progress(share);
    };
    // About these shares of the time; what is in the tooth comes after them.
    constexpr double kOuter = 0.25, kEnamel = 0.5, kDentin = 0.7, kPulp = 0.9;
    const auto mesh = [&](const ScalarField& body) { return meshOf(body, shape.bounds, cellSize, kRelaxations); };
    BuiltinTooth tooth;
    tooth.name = shape.name;
    tooth.fdi = shape.fdi;
    tooth.outer = mesh(shape.outer);
    report(kOuter);
    // The cut of the crown is a little below the cervical line, where dentin wins: no gap at the thin edge of the
    // enamel.
    constexpr double kOverlap = 0.3;
    tooth.enamel = mesh([&](const Vec3& p) { return std::max(shape.outer(p), -shape.cervical(p) - kOverlap); });
    report(kEnamel);
    tooth.dentin = mesh(shape.core);
    report(kDentin);
    tooth.pulp = pulpOf(shape, cellSize);
    report(kPulp);
    return tooth;
}

/// The part of a body that lies in the tooth: decay, or a filling.
TriangleMesh insideTooth(const ToothShape& shape, const ScalarField& body, int triangles) {
    const double cellSize = std::min(cellSizeFor(shape, triangles), kCanalCell);
    return meshOf([&](const Vec3& p) { return std::max(shape.outer(p), body(p)); }, shape.bounds, cellSize,
                  kRelaxations);
}

}  // namespace

BuiltinTooth makeTooth(const ToothRequest& request) { return makeToothReporting(request, {}); }

BuiltinTooth makeToothReporting(const ToothRequest& request, const std::function<void(double)>& progress) {
    TACTOOTH_ASSERT(isPermanentTooth(request.fdi) && request.triangles > 0);
    const ToothShape shape = toothShape(request.fdi, request.seed);
    double cellSize = cellSizeFor(shape, request.triangles);
    BuiltinTooth tooth = meshed(shape, cellSize, progress);
    for (int i = 1; i < kTries && (hasFolds(tooth.outer) || hasFolds(tooth.enamel) || hasFolds(tooth.dentin)); ++i) {
        cellSize *= kFinerCell;
        tooth = meshed(shape, cellSize, progress);
    }
    if (request.lesion) tooth.caries = insideTooth(shape, lesionBody(shape, *request.lesion), request.triangles);
    if (request.lesion && request.lesion->rim)
        tooth.rim = insideTooth(shape, lesionRimBody(shape, *request.lesion), request.triangles);
    if (request.filling) tooth.filling = insideTooth(shape, fillingBody(shape, *request.filling), request.triangles);
    takeMaterials(tooth, request);
    if (mesialX(tooth.fdi) < 0) mirrorLayers(tooth);
    if (progress) progress(1);
    return tooth;
}

void takeMaterials(BuiltinTooth& tooth, const ToothRequest& request) {
    if (request.filling) {
        tooth.fillingMaterial = request.filling->material;
        tooth.materials = request.filling->materials;
    }
    if (request.lesion && request.lesion->rim) {
        const LesionRim& rim = *request.lesion->rim;
        TACTOOTH_ASSERT(!request.filling || request.filling->materials == rim.materials);
        tooth.rimMaterial = rim.material;
        tooth.materials = rim.materials;
    }
}

ToothRequest builtinToothRequest(BuiltinToothKind kind, int triangles, double lesionWidth) {
    TACTOOTH_ASSERT(lesionWidth >= 0 && lesionWidth <= kMaxLesionWidth);
    ToothRequest request{.fdi = numberOf(kind), .triangles = triangles, .seed = 0, .lesion = {}};
    if (lesionWidth > 0) request.lesion = Lesion{LesionSite::Usual, lesionWidth, {}};
    return request;
}

BuiltinTooth makeBuiltinTooth(BuiltinToothKind kind, int triangles, double lesionWidth) {
    return makeTooth(builtinToothRequest(kind, triangles, lesionWidth));
}

std::uint64_t toothFingerprint(const ToothRequest& request) {
    constexpr std::uint32_t kMeshing = 2;  // increase it when the same anatomy gives another mesh
    ByteWriter facts;
    facts.put(kMeshing);
    facts.put(request.fdi);
    facts.put(request.triangles);
    facts.put(request.seed);
    const ToothShape shape = toothShape(request.fdi, request.seed);
    std::vector<ScalarField> fields = {shape.outer, shape.core, shape.cervical, shape.pulp};
    if (request.lesion) fields.push_back(lesionBody(shape, *request.lesion));
    if (request.lesion && request.lesion->rim) fields.push_back(lesionRimBody(shape, *request.lesion));
    if (request.filling) fields.push_back(fillingBody(shape, *request.filling));
    constexpr int kProbes = 7;  // points along each side of the tooth's box: a change of the anatomy changes some value
    for (int i = 0; i < kProbes * kProbes * kProbes; ++i) {
        const Vec3 part = Vec3(i % kProbes + 0.5, i / kProbes % kProbes + 0.5, i / (kProbes * kProbes) + 0.5) / kProbes;
        const Vec3 point = shape.bounds.min() + part.cwiseProduct(shape.bounds.sizes());
        for (const ScalarField& field : fields) facts.put(field(point));
    }
    return checksum(facts.bytes());
}

BuiltinTooth contralateral(BuiltinTooth tooth) {
    TACTOOTH_ASSERT(isPermanentTooth(tooth.fdi));
    constexpr std::array<int, 4> kOther = {2, 1, 4, 3};  // quadrant
    mirrorLayers(tooth);
    tooth.fdi = 10 * kOther[static_cast<std::size_t>(tooth.fdi / 10 - 1)] + tooth.fdi % 10;
    tooth.name = toothName(tooth.fdi);
    return tooth;
}

std::string toothName(int fdi) { return toothShape(fdi).name; }

std::vector<LayerMesh> layersOf(const BuiltinTooth& tooth) {
    std::vector<LayerMesh> layers;
    const MaterialRegistry& materials = *tooth.materials;
    const auto add = [&](MaterialRole role, const TriangleMesh& mesh) {
        const MaterialId id = materials.withRole(role);
        if (!mesh.empty()) layers.push_back({materials.nameOf(id), id, mesh});
    };
    add(MaterialRole::Enamel, tooth.enamel);
    add(MaterialRole::Dentin, tooth.dentin);
    add(MaterialRole::Pulp, tooth.pulp);
    if (!tooth.filling.empty())
        layers.push_back({materials.nameOf(tooth.fillingMaterial), tooth.fillingMaterial, tooth.filling});
    if (!tooth.rim.empty()) layers.push_back({materials.nameOf(tooth.rimMaterial), tooth.rimMaterial, tooth.rim});
    add(MaterialRole::Decay, tooth.caries);
    return layers;
}

Expected<LayeredTooth> layeredTooth(const BuiltinTooth& tooth, std::span<const BuiltinTooth> adjacent) {
    TriangleMesh outer = tooth.outer;
    std::vector<LayerMesh> layers = layersOf(tooth);
    ToothContext toothContext{.mesialX = mesialX(tooth.fdi)};
    if (!adjacent.empty()) toothContext.firstAdjacent = static_cast<std::uint32_t>(outer.triangles.size());
    for (const BuiltinTooth& other : adjacent) {
        append(outer, other.outer);
        for (LayerMesh& layer : layersOf(other)) {
            layer.name = std::to_string(other.fdi) + " " + layer.name;
            layers.push_back(std::move(layer));
        }
    }
    return LayeredTooth::make(std::move(outer), std::move(layers), tooth.materials->withRole(MaterialRole::Enamel),
                              toothContext, *tooth.materials);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/layer_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "collision/bvh/closest_point.h"
#include "geometry/field/isosurface.h"
#include "geometry/mesh/mesh_repair.h"
#include "patient/exterior_surface.h"
#include "patient/messages.h"
#include "patient/pulp_segments.h"
#include "patient/tooth_sections.h"

namespace tactooth {
namespace {

constexpr double kDentinTriangles = 0.25;  // mm
constexpr double kPulpTriangles = 0.15;    // mm
constexpr double kPulpWall = 0.5;          // mm
constexpr double kBeyond =
    0.02;  // mm: the dentin of the root extends beyond its surface, so that no enamel remains on it

/// Largest enamel thickness of a crown of this width, mm: 0.7 to 1 on anterior teeth, 1.3 to 1.6 at the sides of
/// molars.
double thickestEnamel(const TriangleMesh& outer) {
    const SectionProfile profile = sectionProfile(outer);
    const double widest = *std::ranges::max_element(profile.areas);
    const double width = 2 * std::sqrt(widest / 3.14159);  // of the circle with that area
    return std::clamp(0.14 * width, 0.6, 1.5);
}

/// Enamel thickness at a height, mm; negative below the neck.
double enamelAt(double z, double crown, double thickest) {
    const double up = z / crown;
    constexpr double kFull = 0.6;  // share of the crown's height: from there on it has its full thickness at the sides
    return up <= 0 ? -kBeyond : -kBeyond + (thickest + kBeyond) * std::sqrt(std::min(up / kFull, 1.0));
}

/// Distance to a cone with round ends, about.
double distanceTo(const PulpSegment& segment, const Vec3& point) {
    const Vec3 along = segment.b - segment.a;
    const double share = std::clamp(along.dot(point - segment.a) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
    return (point - segment.a - share * along).norm() - (segment.radiusA + share * (segment.radiusB - segment.radiusA));
}

TriangleMesh pulpFrom(const std::vector<PulpSegment>& segments, const DepthField& depth) {
    if (segments.empty()) return {};
    Box3 box;
    for (const PulpSegment& segment : segments) {
        const double radius = std::max(segment.radiusA, segment.radiusB) + 1;
        for (const Vec3& end : {segment.a, segment.b}) {
            box.extend(Vec3(end.array() - radius));
            box.extend(Vec3(end.array() + radius));
        }
    }
    const ScalarField field = [&](const Vec3& point) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const PulpSegment& segment : segments) nearest = std::min(nearest, distanceTo(segment, point));
        return nearest > 1 ? nearest : std::max(nearest, kPulpWall - depth(point));
    };
    const TriangleMesh mesh = isosurface(field, box, {.cellSize = kPulpTriangles});
    return mesh.empty() ? mesh : connectedComponents(mesh).front();
}

/// A scanner that sees inside finds the pulp space itself: the surface then has walls without enamel.
class EnamelDepth {
public:
    EnamelDepth(const SurfacePart& surface, const DepthField& depth) : depth_(depth) {
        ExteriorSurface exterior = exteriorSurface(surface);
        constexpr double kSpecks = 10;  // mm^2: bottoms of deep fissures, not a pulp space
        if (exterior.pulpWallArea > kSpecks)
            exterior_ = std::make_unique<const SurfacePart>(std::move(exterior.exterior));
    }

    [[nodiscard]] bool hasVoid() const { return exterior_ != nullptr; }
    /// Depth below the enamel, mm, negated: negative in the dentin.
    [[nodiscard]] double above(const Vec3& point, double enamel) const {
        const double depth = depth_(point);
        if (!hasVoid()) return enamel - depth;
        return std::max(enamel - closestPoint(*exterior_, point)->distance, -depth - kBeyond);
    }

private:
    const DepthField& depth_;
    std::unique_ptr<const SurfacePart> exterior_;  // none: all of the surface
};

TriangleMesh dentinOf(const TriangleMesh& outer, const EnamelDepth& depth) {
    const Box3 box = boundingBox(outer);
    const double thickest = thickestEnamel(outer), crown = std::max(box.max().z(), 1.0);
    const ScalarField field = [&](const Vec3& point) {
        return depth.above(point, enamelAt(point.z(), crown, thickest));
    };
    const Box3 around(box.min().array() - 1, box.max().array() + 1);
    // The edge of the enamel at the neck is steep: 0.1 mm above it the thickness is 0.25 mm.
    return isosurface(field, around, {.cellSize = kDentinTriangles, .lipschitzBound = 4});
}

std::vector<ImportNote> notesOn(double enamel, bool hasVoid, bool hasPulp) {
    const MessageText& pulp = hasVoid ? msg::kNotePulpVoid : hasPulp ? msg::kNotePulpModelled : msg::kNoteNoPulp;
    return {{ImportNoteTopic::Layers, {msg::kNoteModelled, rounded(enamel, 1)}}, {ImportNoteTopic::Layers, pulp}};
}

}  // namespace

Expected<LayerModel> modelLayers(const TriangleMesh& outer, const Progress& progress,
                                 const MaterialRegistry& materials) {
    bool isStopped = false;
    const auto goesOn = [&](double part) {
        isStopped = isStopped || (progress && !progress(part));
        return !isStopped;
    };
    const SurfacePart surface(outer);
    const DepthField depth = [&](const Vec3& point) { return -signedDistance(surface, point); };
    if (!goesOn(0.1)) return unexpected(msg::kStopped);
    const EnamelDepth enamel(surface, depth);
    if (!goesOn(0.3)) return unexpected(msg::kStopped);
    TriangleMesh dentin = dentinOf(outer, enamel);
    std::vector<PulpSegment> segments;
    if (!enamel.hasVoid()) {
        segments = pulpSegments(depth, surface.tree().box(), [&](double part) { return goesOn(0.5 + 0.3 * part); });
    }
    if (!goesOn(0.8)) return unexpected(msg::kStopped);
    TriangleMesh pulp = pulpFrom(segments, depth);
    if (!goesOn(1)) return unexpected(msg::kStopped);
    LayerModel model;
    model.how = notesOn(thickestEnamel(outer), enamel.hasVoid(), !pulp.empty());
    const auto add = [&](MaterialRole role, TriangleMesh mesh) {
        const MaterialId id = materials.withRole(role);
        if (!mesh.empty()) model.layers.push_back({materials.nameOf(id), id, std::move(mesh)});
    };
    add(MaterialRole::Enamel, outer);
    add(MaterialRole::Dentin, std::move(dentin));
    add(MaterialRole::Pulp, std::move(pulp));
    return model;
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/layered_tooth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/bvh/closest_point.h"
#include "collision/solid/self_intersection.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/mesh_extent.h"
#include "geometry/util/assert.h"
#include "geometry/util/messages.h"
#include "geometry/util/parallel_for.h"
#include "tooth/model/messages.h"

namespace tactooth {
namespace {

/// mm behind a triangle where its material is looked up. Layers of one tooth from a CT agree to 0.02 mm only.
constexpr double kBehindSurface = 0.05;

double signedVolume(const TriangleMesh& mesh) {
    double sixfold = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        sixfold += mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2)));
    }
    return sixfold / 6;
}

Expected<void> checkClosed(const TriangleMesh& mesh, const Message& what) {
    if (mesh.empty()) return unexpected(msg::kSurfaceOfNothing, what);
    if (auto reach = checkExtent(mesh, {msg::kSurfaceOf, what}); !reach) return reach;
    if (const EdgeBalance edges = edgeBalance(mesh); !edges.closed()) {
        return unexpected(msg::kSurfaceOpen, what, edges.odd + edges.against);
    }
    if (!(signedVolume(mesh) > 0)) {
        return unexpected(msg::kSurfaceInsideOut, what);
    }
    return {};
}

Expected<void> checkLayers(const TriangleMesh& outer, const std::vector<LayerMesh>& layers) {
    const Box3 toothBox = boundingBox(outer);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Message what(msg::kLayerNamed, layers[i].name);
        for (std::size_t j = 0; j < i; ++j) {
            if (layers[j].name == layers[i].name) {
                return unexpected(msg::kLayerGivenTwice, what);
            }
        }
        if (auto closed = checkClosed(layers[i].mesh, what); !closed) return unexpected(closed.error());
        if (!toothBox.intersects(boundingBox(layers[i].mesh))) {
            return unexpected(msg::kLayerOutside, what);
        }
    }
    return {};
}

/// Whether some of the sampled vertices of `mesh` lie within `body` or on its surface.
bool reachesInto(const SurfacePart& body, const TriangleMesh& mesh) {
    constexpr std::size_t kLooks = 200;
    TACTOOTH_ASSERT(!mesh.empty());
    const std::size_t stride = std::max<std::size_t>(1, mesh.vertices.size() / kLooks);
    for (std::size_t v = 0; v < mesh.vertices.size(); v += stride) {
        const Vec3 point = mesh.vertices[v].cast<double>();
        if (closestPoint(body, point, kBehindSurface) || contains(body, point)) return true;
    }
    return false;
}

/// Boxes of two bodies may overlap although the bodies do not: a layer of the tooth beside this one.
bool areApart(const SurfacePart& a, const SurfacePart& b) {
    return !reachesInto(a, b.mesh()) && !reachesInto(b, a.mesh());
}

/// Layers in ascending order of this: a later one overrides an earlier one.
std::pair<int, MaterialId> nestingOf(MaterialId material, const MaterialRegistry& materials) {
    TACTOOTH_ASSERT(static_cast<std::size_t>(material) < materials.size());
    return {materials[material].nesting, material};
}

}  // namespace

Expected<LayeredTooth> LayeredTooth::make(TriangleMesh outer, std::vector<LayerMesh> layers, MaterialId body,
                                          const ToothContext& toothContext, const MaterialRegistry& materials) {
    TACTOOTH_ASSERT(std::abs(toothContext.mesialX) == 1);
    if (auto closed = checkClosed(outer, msg::kTheTooth); !closed) return unexpected(closed.error());
    if (auto checked = checkLayers(outer, layers); !checked) return unexpected(checked.error());
    std::ranges::stable_sort(layers, {}, [&](const LayerMesh& layer) { return nestingOf(layer.material, materials); });
    LayeredTooth tooth;
    tooth.materials_ = &materials;
    tooth.body_ = body;
    tooth.toothContext_ = toothContext;
    for (LayerMesh& layer : layers) {
        auto part = std::make_shared<const SurfacePart>(std::move(layer.mesh));
        tooth.layers_.push_back({std::move(layer.name), layer.material, std::move(part)});
    }
    std::vector<SurfaceTag> tags = tooth.tagsOf(outer);
    tooth.outer_ = std::make_shared<const SurfacePart>(std::move(outer), std::move(tags), toothContext.firstAdjacent);
    const bool isAlone = toothContext.firstAdjacent >= tooth.outer_->mesh().triangles.size();
    if (!isAlone) tooth.bodiesOverlap_ = selfIntersectingTriangles(*tooth.outer_).value_or(std::vector{0U}).size() > 0;
    TACTOOTH_ASSERT(tooth.outer_->tags().empty() ||
                    tooth.outer_->tags().size() == tooth.outer_->mesh().triangles.size());
    for (const Layer& layer : tooth.layers_) {
        if (areApart(*tooth.outer_, *layer.part))
            return unexpected(msg::kLayerOutside, Message(msg::kLayerNamed, layer.name));
    }
    return tooth;
}

LayeredTooth LayeredTooth::touchOnly(std::shared_ptr<const SurfacePart> surface, bool closed,
                                     const MaterialRegistry& materials) {
    TACTOOTH_ASSERT(surface != nullptr && !surface->mesh().empty());
    TACTOOTH_ASSERT(std::ranges::all_of(surface->tags(), [&](SurfaceTag tag) { return tag < materials.size(); }));
    LayeredTooth tooth;
    tooth.materials_ = &materials;
    tooth.toothContext_.firstAdjacent = surface->firstAdjacent();
    tooth.outer_ = std::move(surface);
    tooth.touchOnly_ = true;
    tooth.closed_ = closed;
    return tooth;
}

std::shared_ptr<const SurfacePart> LayeredTooth::ownOuter() const {
    TACTOOTH_ASSERT(outer_ != nullptr);
    if (toothContext_.firstAdjacent >= outer_->mesh().triangles.size()) return outer_;
    TaggedMesh own = visibleToothMesh(Surface{.base = outer_});
    return std::make_shared<const SurfacePart>(std::move(own.mesh), std::move(own.tags));
}

Box3 LayeredTooth::ownBox() const {
    TACTOOTH_ASSERT(outer_ != nullptr);
    const TriangleMesh& mesh = outer_->mesh();
    Box3 box;
    for (std::uint32_t t = 0; t < mesh.triangles.size() && t < toothContext_.firstAdjacent; ++t) {
        for (int corner = 0; corner < 3; ++corner) box.extend(mesh.corner(t, corner));
    }
    return box;
}

MaterialId LayeredTooth::materialAt(const Vec3& point) const {
    TACTOOTH_ASSERT(point.allFinite());
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
        if (layer->part->tree().box().contains(point) && contains(*layer->part, point)) return layer->material;
    }
    MaterialId nearest = body_;
    double within = std::numeric_limits<double>::infinity();
    for (const Layer& layer : layers_) {
        const auto hit = closestPoint(*layer.part, point, within);
        if (hit && hit->distance < within) nearest = layer.material, within = hit->distance;
    }
    return nearest;
}

std::vector<SurfaceTag> LayeredTooth::tagsOf(const TriangleMesh& outer) const {
    const auto materialOfAll = [&]() -> std::optional<MaterialId> {
        if (layers_.empty()) return body_;
        for (const Layer& layer : layers_) {
            if (layer.material != layers_.front().material) return std::nullopt;
        }
        return layers_.front().material;
    }();
    if (materialOfAll) {
        if (*materialOfAll == MaterialId{}) return {};
        return std::vector<SurfaceTag>(outer.triangles.size(), static_cast<SurfaceTag>(*materialOfAll));
    }
    std::vector<SurfaceTag> tags(outer.triangles.size());
    parallelFor(outer.triangles.size(), [&](std::size_t t) {
        const Vec3 centre = (outer.corner(t, 0) + outer.corner(t, 1) + outer.corner(t, 2)) / 3;
        const Vec3 area = outer.areaVector(t);
        const Vec3 behind = area.squaredNorm() > 0 ? Vec3(centre - kBehindSurface * area.normalized()) : centre;
        tags[t] = static_cast<SurfaceTag>(materialAt(behind));
    });
    return tags;
}

void LayeredTooth::validate() const {
    const auto validatePart = [](const SurfacePart* part) {
        TACTOOTH_ASSERT(part != nullptr);
        TACTOOTH_ASSERT(!part->mesh().empty());
        TACTOOTH_ASSERT(edgeBalance(part->mesh()).closed());
        TACTOOTH_ASSERT(signedVolume(part->mesh()) > 0);
        TACTOOTH_ASSERT(part->tags().empty() || part->tags().size() == part->mesh().triangles.size());
    };
    validatePart(outer_.get());
    TACTOOTH_ASSERT(outer_->firstAdjacent() == toothContext_.firstAdjacent);
    TACTOOTH_ASSERT(std::abs(toothContext_.mesialX) == 1);
    TACTOOTH_ASSERT(outer_->tree().box().contains(ownBox()));
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        validatePart(layers_[i].part.get());
        TACTOOTH_ASSERT(layers_[i].part->tree().box().intersects(outer_->tree().box()));
        TACTOOTH_ASSERT(i == 0 ||
                        nestingOf(layers_[i - 1].material, *materials_) <= nestingOf(layers_[i].material, *materials_));
        for (std::size_t j = 0; j < i; ++j) TACTOOTH_ASSERT(layers_[j].name != layers_[i].name);
    }
}

}  // namespace tactooth

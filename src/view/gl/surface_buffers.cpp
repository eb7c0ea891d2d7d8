// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/surface_buffers.h"

#include <algorithm>
#include <bit>

#include "geometry/util/assert.h"

namespace tactooth {

namespace {

using MeshPointer = std::shared_ptr<const TriangleMesh>;
using SurfacePointer = std::shared_ptr<const Surface>;

const TriangleMesh& meshOf(const SceneShape& shape) {
    if (const auto* mesh = std::get_if<MeshPointer>(&shape)) return **mesh;
    return std::get<SurfacePointer>(shape)->base->mesh();
}

std::span<const SurfaceTag> tagsOf(const SceneShape& shape) {
    if (std::holds_alternative<MeshPointer>(shape)) return {};
    return std::get<SurfacePointer>(shape)->base->tags();
}

/// A change of one entry of the index buffer.
struct Change {
    std::uint32_t place;
    Triangle triangle;
};

/// The numbers of the triangles whose bits differ between two masks of the same length.
std::vector<std::uint32_t> changedTriangles(const TriangleMask& a, const TriangleMask& b) {
    std::vector<std::uint32_t> changed;
    for (std::size_t word = 0; word < a.size(); ++word) {
        for (std::uint64_t bits = a[word] ^ b[word]; bits != 0; bits &= bits - 1) {
            changed.push_back(static_cast<std::uint32_t>(64 * word) +
                              static_cast<std::uint32_t>(std::countr_zero(bits)));
        }
    }
    return changed;
}

}  // namespace

bool hasTriangles(const SceneShape& shape) {
    if (const auto* mesh = std::get_if<MeshPointer>(&shape)) return *mesh != nullptr && !(*mesh)->empty();
    const SurfacePointer& surface = std::get<SurfacePointer>(shape);
    return surface != nullptr && surface->base != nullptr && !surface->base->mesh().empty();
}

SurfaceBuffers::Prepared SurfaceBuffers::prepare(const SceneShape& shape, const AppearanceZones* zones) {
    TACTOOTH_ASSERT(hasTriangles(shape));
    Prepared prepared;
    prepared.shading = cornerShading(meshOf(shape), tagsOf(shape));
    if (zones != nullptr) applyZones(*zones, meshOf(shape), prepared.shading);
    prepared.mesh = shadingMesh(meshOf(shape), prepared.shading);
    prepared.lodTree = buildLodTree(prepared.mesh);
    return prepared;
}

SurfaceBuffers::SurfaceBuffers(const SceneShape& shape, std::shared_ptr<const AppearanceZones> zones)
    : SurfaceBuffers(shape, zones, prepare(shape, zones.get())) {}

SurfaceBuffers::SurfaceBuffers(const SceneShape& shape, std::shared_ptr<const AppearanceZones> zones, Prepared prepared)
    : shown_(shape),
      zones_(std::move(zones)),
      shading_(std::move(prepared.shading)),
      lodTree_(std::move(prepared.lodTree)),
      hiddenInNode_(lodTree_.nodes.size()),
      mustRefine_(lodTree_.nodes.size()),
      drawIndexOfTriangle_(std::move(prepared.mesh.drawIndexOfTriangle)),
      box_(prepared.mesh.box),
      hidden_((drawIndexOfTriangle_.size() + 63) / 64),
      buffers_(static_cast<std::uint32_t>(prepared.mesh.vertices.size()),
               static_cast<std::uint32_t>(lodTree_.triangles.size())) {
    buffers_.writeVertices(0, prepared.mesh.vertices);
    buffers_.writeTriangles(0, lodTree_.triangles);
}

bool SurfaceBuffers::holds(const SceneShape& shape) const {
    if (shown_.index() != shape.index()) return false;
    if (std::holds_alternative<MeshPointer>(shape)) return shown_ == shape;
    return std::get<SurfacePointer>(shown_)->base->id() == std::get<SurfacePointer>(shape)->base->id();
}

bool SurfaceBuffers::update(const SceneShape& shape) {
    TACTOOTH_ASSERT(holds(shape));
    if (updated_ && shown_ == shape) return false;
    lastUpload_ = updated_ ? 0 : drawIndexOfTriangle_.size();
    changed_ = updated_ ? Box3() : box_;
    if (const auto* pointer = std::get_if<SurfacePointer>(&shape)) {
        const Surface& surface = **pointer;
        hide(surface.hidden != nullptr ? *surface.hidden : TriangleMask{});
        patches_.update(surface, shading_, zones_.get());
        changed_.extend(patches_.changed());
        lastUpload_ += patches_.lastUpload();
    }
    shown_ = shape;
    updated_ = true;
    return true;
}

void SurfaceBuffers::hide(const TriangleMask& mask) {
    TriangleMask wanted = mask;
    wanted.resize(hidden_.size());
    const std::vector<std::uint32_t> toggled = changedTriangles(hidden_, wanted);
    std::vector<Change> changes;
    changes.reserve(toggled.size());
    for (const std::uint32_t triangle : toggled) {
        for (int corner = 0; corner < 3; ++corner) changed_.extend(meshOf(shown_).corner(triangle, corner));
        const std::uint32_t place = drawIndexOfTriangle_[triangle];
        const Triangle& shown = lodTree_.triangles[place];
        const bool hides = isHidden(wanted, triangle);
        changes.push_back({place, hides ? Triangle{shown[0], shown[0], shown[0]} : shown});
        std::uint32_t& hidden = hiddenInNode_[place / kTrianglesPerLeaf];
        hides ? ++hidden : --hidden;
    }
    std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.place < b.place; });
    std::vector<Triangle> run;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        run.push_back(changes[i].triangle);
        if (i + 1 < changes.size() && changes[i + 1].place == changes[i].place + 1) continue;
        buffers_.writeTriangles(changes[i].place + 1 - static_cast<std::uint32_t>(run.size()), run);
        run.clear();
    }
    lastUpload_ += changes.size();
    hidden_ = std::move(wanted);
    if (!changes.empty()) markChangedNodes();
}

void SurfaceBuffers::markChangedNodes() {
    for (std::size_t i = 0; i < lodTree_.nodes.size(); ++i) {
        const LodNode& node = lodTree_.nodes[i];
        mustRefine_[i] = hiddenInNode_[i] > 0;
        for (std::size_t child = 0; child < node.children; ++child) {
            if (mustRefine_[node.firstChild + child]) mustRefine_[i] = true;
        }
    }
}

void SurfaceBuffers::draw(const ClusterCuller& culler) {
    ranges_.clear();
    visibleRanges(culler, lodTree_, mustRefine_, ranges_);
    buffers_.draw(ranges_);
    patches_.draw(culler);
}

}  // namespace tactooth

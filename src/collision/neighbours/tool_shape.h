// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/bvh/surface.h"
#include "collision/narrow/triangle3.h"
#include "collision/neighbours/support_planes.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// The moving body of a contact query: a tool's mesh with the data computed once for it. Read-only after construction.
class ToolShape {
public:
    explicit ToolShape(TriangleMesh mesh);

    [[nodiscard]] const SurfacePart& part() const { return part_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return part_.mesh(); }
    /// The corners of a triangle in the tool's frame: the numbers of the mesh, but contiguous in memory.
    [[nodiscard]] Triangle3 corners(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < corners_.size());
        const std::array<Vec3f, 3>& c = corners_[triangle];
        return {c[0].cast<double>(), c[1].cast<double>(), c[2].cast<double>()};
    }
    /// The corners of a triangle of the tool standing at `toolInTooth`, in the tooth's frame.
    [[nodiscard]] Triangle3 cornersAt(const Pose& toolInTooth, std::uint32_t triangle) const {
        Triangle3 moved = corners(triangle);
        for (Vec3& corner : moved) corner = toolInTooth * corner;
        return moved;
    }
    /// The corners in single precision, as the mesh has them.
    [[nodiscard]] const std::array<Vec3f, 3>& floatCorners(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < corners_.size());
        return corners_[triangle];
    }
    /// The corners of a triangle axis by axis, twice: in lanes 0-2 and 4-6.
    struct alignas(32) CornerLanes {
        float axis[3][8];
    };
    [[nodiscard]] const CornerLanes& cornerLanes(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < cornerLanes_.size());
        return cornerLanes_[triangle];
    }
    /// Unit and outward; zero for a triangle without area.
    [[nodiscard]] const Vec3f& normal(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < normals_.size());
        return normals_[triangle];
    }
    /// A ball around the corners of a triangle.
    struct Ball {
        Vec3f centre;
        float radius;
    };
    [[nodiscard]] const Ball& ball(std::uint32_t triangle) const {
        TACTOOTH_ASSERT(triangle < balls_.size());
        return balls_[triangle];
    }
    /// Planes and boxes of up to eight triangles; the lanes are those of the tree's leaf.
    struct alignas(32) Faces {
        float normal[3][AabbTree::kWidth];  // unit and outward; zero for a triangle without area
        float lowOffset[AabbTree::kWidth];  // the corners' least and greatest dot product with the normal
        float highOffset[AabbTree::kWidth];
        float low[3][AabbTree::kWidth];  // box
        float high[3][AabbTree::kWidth];
        float far[AabbTree::kWidth];  // distance of the farthest corner from the origin, mm: the lever of a rotation
    };
    [[nodiscard]] const Faces& faces(AabbTree::Link leaf) const {
        TACTOOTH_ASSERT(leaf.isLeaf() && leaf.index() < faces_.size());
        return faces_[leaf.index()];
    }
    /// For each child of a node of the tree: the greatest distance of its points from the origin, mm.
    using Far = std::array<float, AabbTree::kWidth>;
    [[nodiscard]] const Far& far(AabbTree::Link node) const {
        TACTOOTH_ASSERT(!node.isLeaf() && node.index() < far_.size());
        return far_[node.index()];
    }
    struct Boxf {
        float low[3], high[3];
    };
    /// The box of a node of the tree.
    struct Bound : Boxf {
        float far;  ///< greatest distance of its points from the origin, mm
    };
    [[nodiscard]] const Bound& bound(AabbTree::Link node) const {
        TACTOOTH_ASSERT(!node.isLeaf() && node.index() < bounds_.size());
        return bounds_[node.index()];
    }
    /// The support planes (k-DOP) of the whole tool, in the tool's frame.
    [[nodiscard]] const SupportPlanes& supportPlanes() const { return supportPlanes_; }
    /// Centre of the bounding box in the tool frame, mm.
    [[nodiscard]] const Vec3& centre() const { return centre_; }
    /// Every vertex lies within this distance of the centre, mm.
    [[nodiscard]] double radius() const { return radius_; }

private:
    SurfacePart part_;
    std::vector<std::array<Vec3f, 3>> corners_;
    std::vector<CornerLanes> cornerLanes_;
    std::vector<Vec3f> normals_;
    std::vector<Ball> balls_;
    std::vector<Faces> faces_;
    std::vector<Far> far_;
    std::vector<Bound> bounds_;
    SupportPlanes supportPlanes_;
    Vec3 centre_ = Vec3::Zero();
    double radius_ = 0;
};

}  // namespace tactooth

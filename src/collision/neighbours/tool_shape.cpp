// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/tool_shape.h"

#include <algorithm>

#include "collision/narrow/round_up.h"

namespace tactooth {
namespace {

ToolShape::Ball ballOf(const std::array<Vec3f, 3>& corners) {
    const Vec3f centre = (corners[0] + corners[1] + corners[2]) / 3;
    float radius = 0;
    for (const Vec3f& corner : corners) radius = std::max(radius, (corner - centre).norm());
    return {centre, radius * kRoundUp};
}

Vec3f normalOf(const std::array<Vec3f, 3>& corners) {
    const Vec3 area = (corners[1] - corners[0]).cast<double>().cross((corners[2] - corners[0]).cast<double>());
    const double length = area.norm();
    return length > 0 ? Vec3f((area / length).cast<float>()) : Vec3f(Vec3f::Zero());
}

ToolShape::CornerLanes lanesOf(const std::array<Vec3f, 3>& corners) {
    ToolShape::CornerLanes lanes;
    for (int axis = 0; axis < 3; ++axis) {
        for (int lane = 0; lane < 8; ++lane) lanes.axis[axis][lane] = corners[std::min(lane % 4, 2)][axis];
    }
    return lanes;
}

ToolShape::Faces facesOf(const AabbTree::Leaf& leaf) {
    ToolShape::Faces faces{};
    for (int lane = 0; lane < AabbTree::kWidth; ++lane) {
        const Vec3f a(leaf.corner[0][0][lane], leaf.corner[0][1][lane], leaf.corner[0][2][lane]);
        const Vec3f b(leaf.corner[1][0][lane], leaf.corner[1][1][lane], leaf.corner[1][2][lane]);
        const Vec3f c(leaf.corner[2][0][lane], leaf.corner[2][1][lane], leaf.corner[2][2][lane]);
        const Vec3f normal = normalOf({a, b, c});
        const Vec3f low = a.cwiseMin(b).cwiseMin(c);
        const Vec3f high = a.cwiseMax(b).cwiseMax(c);
        for (int axis = 0; axis < 3; ++axis) {
            faces.normal[axis][lane] = normal[axis];
            faces.low[axis][lane] = low[axis];
            faces.high[axis][lane] = high[axis];
        }
        const float offsets[] = {normal.dot(a), normal.dot(b), normal.dot(c)};
        faces.lowOffset[lane] = *std::min_element(offsets, offsets + 3);
        faces.highOffset[lane] = *std::max_element(offsets, offsets + 3);
        faces.far[lane] = kRoundUp * std::max({a.norm(), b.norm(), c.norm()});
    }
    return faces;
}

ToolShape::Far farOf(const AabbTree::Node& node) {
    ToolShape::Far far{};
    for (int i = 0; i < AabbTree::kWidth; ++i) {
        if (!(node.low[0][i] <= node.high[0][i])) continue;  // no child
        Vec3f corner;
        for (int axis = 0; axis < 3; ++axis)
            corner[axis] = std::max(std::abs(node.low[axis][i]), std::abs(node.high[axis][i]));
        far[i] = kRoundUp * corner.norm();
    }
    return far;
}

ToolShape::Bound boundOf(const AabbTree::Node& node, const ToolShape::Far& far) {
    ToolShape::Bound bound;
    for (int axis = 0; axis < 3; ++axis) {  // an absent child's box is inverted and infinite
        bound.low[axis] = *std::min_element(node.low[axis], node.low[axis] + AabbTree::kWidth);
        bound.high[axis] = *std::max_element(node.high[axis], node.high[axis] + AabbTree::kWidth);
    }
    bound.far = *std::max_element(far.begin(), far.end());
    return bound;
}

}  // namespace

ToolShape::ToolShape(TriangleMesh mesh) : part_(std::move(mesh)), supportPlanes_(part_.mesh()) {
    const TriangleMesh& own = part_.mesh();
    corners_.reserve(own.triangles.size());
    for (const Triangle& t : own.triangles)
        corners_.push_back({own.vertices[t[0]], own.vertices[t[1]], own.vertices[t[2]]});
    for (const std::array<Vec3f, 3>& corners : corners_) {
        cornerLanes_.push_back(lanesOf(corners));
        normals_.push_back(normalOf(corners));
        balls_.push_back(ballOf(corners));
    }
    for (const AabbTree::Leaf& leaf : part_.tree().leaves()) faces_.push_back(facesOf(leaf));
    for (const AabbTree::Node& node : part_.tree().nodes()) {
        far_.push_back(farOf(node));
        bounds_.push_back(boundOf(node, far_.back()));
    }
    if (own.empty()) return;
    centre_ = part_.tree().box().center();
    // Vertices that no triangle uses do not count.
    for (const std::array<Vec3f, 3>& corners : corners_) {
        for (const Vec3f& corner : corners) radius_ = std::max(radius_, (corner.cast<double>() - centre_).norm());
    }
    TACTOOTH_ASSERT(centre_.allFinite() && radius_ >= 0);
    TACTOOTH_ASSERT(faces_.size() == part_.tree().leaves().size());
    TACTOOTH_ASSERT(far_.size() == bounds_.size());
}

}  // namespace tactooth

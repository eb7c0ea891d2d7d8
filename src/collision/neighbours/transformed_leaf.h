// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Private to near_clusters.cpp: boxes and leaves of a tooth, transformed into the tool's frame eight at a time.

#include "collision/neighbours/contact_margin.h"
#include "collision/neighbours/tool_shape.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {

[[nodiscard]] inline Vec3x8 broadcast(const Vec3f& v) { return Vec3x8::all(v.x(), v.y(), v.z()); }

}  // namespace tactooth

namespace tactooth::broadphase {

struct Box8 {
    Vec3x8 low, high;
};

using Boxf = ToolShape::Boxf;

/// One bit for each of eight boxes that, grown by its `grow`, overlaps `other`.
inline std::uint32_t overlaps(const Box8& boxes, Float8 grow, const Boxf& other) {
    return lessEqual(boxes.low.x - grow, Float8::all(other.high[0])) &
           lessEqual(Float8::all(other.low[0]), boxes.high.x + grow) &
           lessEqual(boxes.low.y - grow, Float8::all(other.high[1])) &
           lessEqual(Float8::all(other.low[1]), boxes.high.y + grow) &
           lessEqual(boxes.low.z - grow, Float8::all(other.high[2])) &
           lessEqual(Float8::all(other.low[2]), boxes.high.z + grow);
}

/// Boxes stored in memory, so that one of the eight can be picked.
struct Spilled {
    float low[3][8], high[3][8];

    explicit Spilled(const Box8& boxes) { boxes.low.store(low), boxes.high.store(high); }
    [[nodiscard]] Boxf pick(int i) const {
        TACTOOTH_ASSERT(i >= 0 && i < 8);
        return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
    }
};

/// Rotation and translation from the tooth's frame to the tool's, in single precision.
struct FrameTransform {
    Vec3x8 row[3];       // rows of the rotation, each component broadcast
    Vec3x8 absolute[3];  // their absolute values
    Vec3x8 origin;       // the tool's origin in the tooth's frame

    FrameTransform() = default;
    explicit FrameTransform(const Pose& toolInTooth) {
        const Eigen::Matrix3f rotation = toolInTooth.rotation.toRotationMatrix().transpose().cast<float>();
        for (int i = 0; i < 3; ++i) {
            row[i] = Vec3x8::all(rotation(i, 0), rotation(i, 1), rotation(i, 2));
            absolute[i] = Vec3x8::all(std::abs(rotation(i, 0)), std::abs(rotation(i, 1)), std::abs(rotation(i, 2)));
        }
        const Vec3f p = toolInTooth.position.cast<float>();
        origin = Vec3x8::all(p.x(), p.y(), p.z());
    }
    [[nodiscard]] Vec3x8 direction(const Vec3x8& d) const { return {dot(row[0], d), dot(row[1], d), dot(row[2], d)}; }
    [[nodiscard]] Vec3x8 point(const Vec3x8& p) const {
        const Vec3x8 q = p - origin;
        return {dot(row[0], q), dot(row[1], q), dot(row[2], q)};
    }
};

/// The shifts of the tool's origin in a contact margin, in the tool's frame, in single precision.
struct TranslationBounds {
    Vec3f along = Vec3f::Zero();
    float around = 0;
    Vec3f low = Vec3f::Zero(), high = Vec3f::Zero();  // box around all shifts

    TranslationBounds() = default;
    TranslationBounds(const ContactMargin& contactMargin, const Pose& toolInTooth, double slack)
        : along((toolInTooth.rotation.conjugate() * contactMargin.along).cast<float>()),
          around(static_cast<float>(contactMargin.around + slack + kFewRoundings * contactMargin.along.norm())),
          low(along.cwiseMin(0).array() - around),
          high(along.cwiseMax(0).array() + around) {}

    /// How much the shifts can reduce a gap along `normal` (from tooth to tool), mm.
    [[nodiscard]] float closing(const Vec3f& normal) const { return around + std::max(0.0F, -normal.dot(along)); }
};

/// A direction of the tool's frame, and the interval that a leaf of the tooth covers along it, mm.
struct Extent {
    Vec3f direction = Vec3f::Zero();
    float low = 0, high = 0;
};

inline Extent extentOf(const Vec3x8 (&corner)[3], const Vec3f& direction) {
    const Vec3x8 n = Vec3x8::all(direction.x(), direction.y(), direction.z());
    const Float8 a = dot(n, corner[0]);
    const Float8 b = dot(n, corner[1]);
    const Float8 c = dot(n, corner[2]);
    return {direction, lowest(min(min(a, b), c)), highest(max(max(a, b), c))};
}

/// A leaf of the tooth in the tool's frame.
struct TransformedLeaf {
    const AabbTree::Leaf* leaf;
    Vec3x8 corner[3];
    Boxf box;
    Boxf grown;             // by the contact margin
    std::uint32_t present;  // one bit for each triangle that is there
    Vec3x8 normal;          // of the triangles
    Extent bySum;           // along their mean normal
    bool isKept = false;    // it was written to the list

    TransformedLeaf(const AabbTree::Leaf& its, const FrameTransform& turn, const TranslationBounds& shifts)
        : leaf(&its) {
        for (int i = 0; i < 3; ++i) corner[i] = turn.point(Vec3x8::load(its.corner[i]));
        const Vec3x8 lowEnd = min(min(corner[0], corner[1]), corner[2]);
        const Vec3x8 highEnd = max(max(corner[0], corner[1]), corner[2]);
        box = {{lowest(lowEnd.x), lowest(lowEnd.y), lowest(lowEnd.z)},
               {highest(highEnd.x), highest(highEnd.y), highest(highEnd.z)}};
        for (int axis = 0; axis < 3; ++axis) {
            grown.low[axis] = box.low[axis] - shifts.high[axis];
            grown.high[axis] = box.high[axis] - shifts.low[axis];
        }
    }

    /// Finds the triangles' normals and their mean normal: the direction of the sum of the area vectors, along which
    /// nearly flat triangles are thinnest.
    void findNormals() {
        const Vec3x8 area8 = cross(corner[1] - corner[0], corner[2] - corner[0]);
        // A triangle without area gets a short normal. Its slabs are narrow, but still a bound. (The squares of longer
        // normals do not underflow.)
        const Float8 length8 = max(sqrt(dot(area8, area8)), Float8::all(1e-18F));
        normal = {area8.x / length8, area8.y / length8, area8.z / length8};
        float area[3][8];
        area8.store(area);
        Vec3f sum = Vec3f::Zero();
        for (std::uint32_t i = 0; i < leaf->count; ++i) sum += Vec3f(area[0][i], area[1][i], area[2][i]);
        const float length = sum.norm();
        if (length > 0) bySum = extentOf(corner, sum / length);
    }
};

}  // namespace tactooth::broadphase

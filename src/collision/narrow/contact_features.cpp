// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/contact_features.h"

#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// The contact features of two polyhedra (corner and face, edge and edge): D. Baraff, "Analytical Methods for Dynamic
// Simulation of Non-penetrating Rigid Bodies", SIGGRAPH 1989, section 4. Differs from the paper: the features are found
// by projecting both triangles along the direction of approach.

namespace tactooth {
namespace {

constexpr double kParallel = 1e-9;  // sine of the angle below which edges have no common normal

using Point2 = Vec2;

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

using Flat = std::array<Point2, 3>;

/// Whether a point lies in the triangle or on its border. The triangle may run in either sense.
bool isIn(const Flat& triangle, const Point2& point) {
    bool left = true;
    bool right = true;
    for (int i = 0; i < 3; ++i) {
        const double side = cross(triangle[(i + 1) % 3] - triangle[i], point - triangle[i]);
        left &= side >= 0;
        right &= side <= 0;
    }
    return left || right;
}

bool edgesCross(const Flat& a, int i, const Flat& b, int k) {
    const Point2 along = a[(i + 1) % 3] - a[i];
    const Point2 other = b[(k + 1) % 3] - b[k];
    const auto parts = [](const Point2& line, const Point2& p, const Point2& q) {
        return (cross(line, p) >= 0) != (cross(line, q) >= 0);
    };
    return parts(along, b[k] - a[i], b[(k + 1) % 3] - a[i]) && parts(other, a[i] - b[k], a[(i + 1) % 3] - b[k]);
}

/// A vector as a unit vector on the side of `up`. None if it is shorter than rounding of `scale` may explain.
std::optional<Vec3> unitToward(const Vec3& vector, double scale, const Vec3& up) {
    TACTOOTH_ASSERT(!(scale < 0));
    const double length = vector.norm();
    if (!(length > kParallel * scale)) return std::nullopt;
    return Vec3((vector.dot(up) < 0 ? -1 : 1) / length * vector);
}

std::optional<Vec3> faceNormal(const Triangle3& triangle, const Vec3& up) {
    const Vec3 a = triangle[1] - triangle[0];
    const Vec3 b = triangle[2] - triangle[0];
    return unitToward(a.cross(b), a.norm() * b.norm(), up);
}

std::optional<FeatureGap> edgeGap(const Triangle3& tooth, int i, const Triangle3& tool, int k, const Vec3& up) {
    const Vec3& p = tooth[i];
    const Vec3 edge = tooth[(i + 1) % 3] - p;
    const Vec3 other = tool[(k + 1) % 3] - tool[k];
    const Vec3 across = edge.cross(other);
    const auto normal = unitToward(across, edge.norm() * other.norm(), up);
    if (!normal) return std::nullopt;
    const Vec3 between = tool[k] - p;
    const double along = between.cross(other).dot(across) / across.squaredNorm();
    return FeatureGap{normal->dot(between), *normal, p + along * edge};
}

}  // namespace

ContactFeatures::ContactFeatures(const Triangle3& tooth, const Triangle3& tool, const Vec3& up) {
    TACTOOTH_ASSERT(isUnit(up));
    const Vec3 x = up.unitOrthogonal();
    const Vec3 y = up.cross(x);
    Flat below, above;
    for (int i = 0; i < 3; ++i) {
        below[i] = {x.dot(tooth[i]), y.dot(tooth[i])};
        above[i] = {x.dot(tool[i]), y.dot(tool[i])};
    }
    for (int i = 0; i < 3; ++i) {
        if (isIn(below, above[i])) pairs[count++] = {FeaturePair::Kind::CornerOverFace, 0, i};
        if (isIn(above, below[i])) pairs[count++] = {FeaturePair::Kind::FaceOverCorner, i, 0};
        for (int k = 0; k < 3; ++k) {
            if (edgesCross(below, i, above, k)) pairs[count++] = {FeaturePair::Kind::EdgeOverEdge, i, k};
        }
    }
}

std::optional<FeatureGap> gapBetween(const FeaturePair& pair, const Triangle3& tooth, const Triangle3& tool,
                                     const Vec3& up) {
    TACTOOTH_ASSERT(isUnit(up));
    TACTOOTH_ASSERT(pair.tooth >= 0 && pair.tooth < 3);
    TACTOOTH_ASSERT(pair.tool >= 0 && pair.tool < 3);
    if (pair.kind == FeaturePair::Kind::EdgeOverEdge) return edgeGap(tooth, pair.tooth, tool, pair.tool, up);
    if (pair.kind == FeaturePair::Kind::CornerOverPlane) return std::nullopt;
    const bool isCorner = pair.kind == FeaturePair::Kind::CornerOverFace;
    const auto normal = faceNormal(isCorner ? tooth : tool, up);
    if (!normal) return std::nullopt;
    const Vec3 point = isCorner ? tool[pair.tool] : tooth[pair.tooth];
    return FeatureGap{isCorner ? normal->dot(point - tooth[0]) : normal->dot(tool[0] - point), *normal, point};
}

}  // namespace tactooth

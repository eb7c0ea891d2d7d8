// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/contact_directions.h"

#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {
namespace {

Vec3 edgeOf(const Triangle3& triangle, int i) { return triangle[(i + 1) % 3] - triangle[i]; }

}  // namespace

ContactDirections::ContactDirections(const Triangle3& tooth, const Triangle3& tool) {
    std::array<Vec3, 3> ofTooth, ofTool;
    for (int i = 0; i < 3; ++i) ofTooth[i] = edgeOf(tooth, i), ofTool[i] = edgeOf(tool, i);
    addBothSenses(ofTooth[0].cross(ofTooth[1]));
    addBothSenses(ofTool[0].cross(ofTool[1]));
    for (const Vec3& edge : ofTooth) {
        for (const Vec3& other : ofTool) addBothSenses(edge.cross(other));
    }
    TACTOOTH_ASSERT(count_ % 2 == 0 && count_ <= kOfPair);
}

void ContactDirections::add(const Vec3& direction) {
    TACTOOTH_ASSERT(isUnit(direction));
    TACTOOTH_ASSERT(count_ < kCapacity);
    unit_[count_++] = direction;
}

void ContactDirections::addTilted(const Triangle3& tooth, const Triangle3& tool, double least, double reach) {
    TACTOOTH_ASSERT(count_ + kTilted <= kCapacity);
    for (int i = 0; i < 3; ++i) {
        const Vec3 ofTooth = edgeOf(tooth, i);
        const Vec3 ofTool = edgeOf(tool, i);
        for (int k = 0; k < 3; ++k) {
            tiltOver(ofTooth, tool[k] - tooth[i], least, reach);
            tiltOver(ofTool, tool[i] - tooth[k], least, reach);
        }
    }
}

const Vec3& ContactDirections::operator[](int i) const {
    TACTOOTH_ASSERT(i >= 0 && i < count_);
    return unit_[i];
}

void ContactDirections::addBothSenses(const Vec3& direction) {
    const double length = direction.norm();
    if (!(length > 0)) return;
    unit_[count_++] = direction / length;
    unit_[count_++] = direction / -length;
}

void ContactDirections::tiltOver(const Vec3& edge, const Vec3& fromToothToTool, double least, double reach) {
    if (!(fromToothToTool.cross(edge).squaredNorm() < reach * edge.squaredNorm())) return;
    const Vec3 across = fromToothToTool - fromToothToTool.dot(edge) / edge.squaredNorm() * edge;
    const double share = least / across.squaredNorm();
    if (!(least * share < 1)) return;  // the corner is nearer than that already
    const Vec3 up = share * across;
    const Vec3 aside = std::sqrt(1 - least * share) * edge.cross(across).normalized();
    unit_[count_++] = up + aside;
    unit_[count_++] = up - aside;
}

}  // namespace tactooth

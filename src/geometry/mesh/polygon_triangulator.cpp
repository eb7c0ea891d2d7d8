// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/polygon_triangulator.h"

#include <algorithm>
#include <array>

#include "geometry/util/assert.h"
#include "geometry/util/messages.h"

// Ear clipping (see ear_clipper.h) of the outline's projection along one axis. Ours differs in what comes first: a face
// that a fan covers gets the fan, and corners that rounding has made degenerate do not fail.

namespace tactooth {
namespace {

using Corners = std::span<const std::uint32_t>;
using Positions = std::span<const Vec3f>;

/// Largest number of tests of pairs of edges, and of corners against triangles, for one face: about a second.
constexpr std::size_t kMaxTests = 100'000'000;

/// The corners of a face relative to its first corner.
class FromFirst {
public:
    FromFirst(Positions positions, Corners corners)
        : positions_(positions), corners_(corners), first_(positions[corners[0]].cast<double>()) {}

    [[nodiscard]] std::size_t size() const { return corners_.size(); }
    [[nodiscard]] Vec3 to(std::size_t i) const {
        TACTOOTH_ASSERT(i < corners_.size() && corners_[i] < positions_.size());
        return positions_[corners_[i]].cast<double>() - first_;
    }

    /// Twice the area times the normal (M. Newell's formula, in I. Sutherland et al. 1974).
    [[nodiscard]] Vec3 areaVector() const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 2; i < size(); ++i) sum += to(i - 1).cross(to(i));
        return sum;
    }

    /// Whether all corners are on one line, or nearly.
    [[nodiscard]] bool isFlat() const {
        constexpr double kFlat = 1e-4;
        double area = 0, size2 = 0;
        for (std::size_t i = 1; i < size(); ++i) {
            if (i > 1) area += to(i - 1).cross(to(i)).norm();
            size2 = std::max(size2, to(i).squaredNorm());
        }
        return area <= kFlat * size2;
    }

    /// Whether the fan from the first corner covers the face: seen from that corner, the others follow each other in
    /// one half-plane. Each triangle must clearly have an area, so that rounding cannot have moved its corners off one
    /// line.
    [[nodiscard]] bool isFan(const Vec3& normal) const {
        constexpr double kClear = 1e-5;  // a face of 10,000 corners around a circle still is a fan
        const double margin = kClear * normal.norm();
        const auto turnsLeft = [&](const Vec3& a, const Vec3& b) {
            return a.cross(b).dot(normal) > margin * (a.squaredNorm() + b.squaredNorm());
        };
        const Vec3 begin = to(1);
        for (std::size_t i = 2; i < size(); ++i) {
            if (!turnsLeft(begin, to(i)) || !turnsLeft(to(i - 1), to(i))) return false;
        }
        return true;
    }

private:
    Positions positions_;
    Corners corners_;
    Vec3 first_;
};

void addFan(Corners corners, std::vector<Triangle>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i) triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace

const MessageText* PolygonTriangulator::split(Positions positions, Corners corners, std::vector<Triangle>& triangles) {
    TACTOOTH_ASSERT(corners.size() > 3);
    const FromFirst face(positions, corners);
    if (face.isFan(face.areaVector())) return addFan(corners, triangles), nullptr;
    takeDistinct(corners);
    if (distinct_.size() < 3) return addFan(corners, triangles), nullptr;  // without area: the report counts it
    if (distinct_.size() == 3) return addFan(distinct_, triangles), nullptr;
    const FromFirst clean(positions, distinct_);
    const Vec3 normal = clean.areaVector();
    if (clean.isFan(normal)) return addFan(distinct_, triangles), nullptr;
    if (distinct_.size() == 4) {  // the other diagonal of a quadrilateral, which may be far from plane
        const std::array<std::uint32_t, 4> turned = {distinct_[1], distinct_[2], distinct_[3], distinct_[0]};
        if (FromFirst(positions, turned).isFan(normal)) return addFan(turned, triangles), nullptr;
    }
    const std::size_t before = triangles.size();
    const MessageText* const problem = triangulateAnyShape(positions, normal, triangles);
    if (problem == nullptr) return nullptr;
    triangles.resize(before);
    if (!clean.isFlat()) return problem;
    addFan(distinct_, triangles);  // a sliver, where rounding may have put the corners in any order
    return nullptr;
}

const MessageText* PolygonTriangulator::triangulateAnyShape(Positions positions, const Vec3& normal,
                                                            std::vector<Triangle>& triangles) {
    TACTOOTH_ASSERT(distinct_.size() > 3);
    if (normal.isZero(0)) return &msg::kOutlineCrossesItself;
    outline_.set(positions, distinct_, normal);
    switch (outline_.crossing(kMaxTests)) {
        case ProjectedPolygon::Crossing::Found:
            return &msg::kOutlineCrossesItself;
        case ProjectedPolygon::Crossing::NotKnown:
            return &msg::kFaceTooLarge;
        case ProjectedPolygon::Crossing::None:
            break;
    }
    switch (clipper_.clip(outline_, kMaxTests, triangles)) {
        case EarClipper::Result::NoEar:
            return &msg::kOutlineCrossesItself;
        case EarClipper::Result::LimitReached:
            return &msg::kFaceTooLarge;
        case EarClipper::Result::Done:
            break;
    }
    return nullptr;
}

/// Takes the corners without duplicates and without spikes (edges to a point and straight back).
void PolygonTriangulator::takeDistinct(Corners corners) {
    distinct_.clear();
    for (const std::uint32_t corner : corners) {
        const std::size_t count = distinct_.size();
        if (count > 0 && distinct_.back() == corner) continue;
        if (count > 1 && distinct_[count - 2] == corner) {
            distinct_.pop_back();
        } else {
            distinct_.push_back(corner);
        }
    }
    // The same where the end meets the beginning.
    std::size_t begin = 0, end = distinct_.size();
    while (end - begin > 2) {
        if (distinct_[begin] == distinct_[end - 1]) {
            --end;
        } else if (distinct_[begin + 1] == distinct_[end - 1]) {
            ++begin;
        } else if (distinct_[begin] == distinct_[end - 2]) {
            end -= 1;
        } else {
            break;
        }
    }
    distinct_.assign(distinct_.begin() + static_cast<std::ptrdiff_t>(begin),
                     distinct_.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace tactooth

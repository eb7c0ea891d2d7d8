// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/revolution_envelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/util/assert.h"
#include "tooth/model/messages.h"

// Own method. The signed distance to a solid of revolution is that to its profile in the half-plane of radius and
// height. A uniform grid lists the segments that can be nearest to the points of each of its cells.

namespace tactooth {
namespace {

constexpr double kGridMargin = 0.5;      ///< mm around the profile; the rare farther points test every segment
constexpr double kFinestCell = 0.04;     ///< mm; a cell holds two or three segments of a usual bur
constexpr double kMaxCells = 20'000;     ///< keeps the grid of a tool 30 mm long below 200 KB
constexpr double kOnSurface = 1e-9;      ///< mm; a shorter offset has no direction, so that the normal is used
constexpr double kTieTolerance = 1e-18;  ///< mm^2; two segments have the same distance at their common corner

}  // namespace

Expected<RevolutionEnvelope> RevolutionEnvelope::make(const TriangleMesh& bur) {
    std::vector<ProfilePoint> profile = revolutionProfile(bur);
    const auto reaches = [](const ProfilePoint& point) { return point.radius > 0; };
    if (profile.size() < 3 || std::none_of(profile.begin(), profile.end(), reaches)) {
        return unexpected(msg::kToolWithoutExtent);
    }
    RevolutionEnvelope envelope(std::move(profile));
    TACTOOTH_ASSERT(envelope.maxRadius() > 0 && std::isfinite(envelope.maxRadius()));
    TACTOOTH_ASSERT(envelope.top() > envelope.bottom());
    return envelope;
}

RevolutionEnvelope::RevolutionEnvelope(std::vector<ProfilePoint> profile) : profile_(std::move(profile)) {
    for (std::size_t i = 0; i + 1 < profile_.size(); ++i) {
        const double dr = profile_[i + 1].radius - profile_[i].radius;
        const double dz = profile_[i + 1].z - profile_[i].z;
        const double length = std::hypot(dr, dz);
        if (length > 0) segments_.push_back({profile_[i], dr / length, dz / length, length});
        maxRadius_ = std::max(maxRadius_, profile_[i].radius);
    }
    TACTOOTH_ASSERT(!segments_.empty());
    TACTOOTH_ASSERT(segments_.size() <= std::numeric_limits<std::uint16_t>::max());  // they are numbered by 16 bits
    allSegments_.resize(segments_.size());
    std::iota(allSegments_.begin(), allSegments_.end(), std::uint16_t{0});
    buildGrid();
}

void RevolutionEnvelope::buildGrid() {
    const double width = maxRadius_ + kGridMargin;
    const double height = top() - bottom() + 2 * kGridMargin;
    cellSize_ = std::max(kFinestCell, std::sqrt(width * height / kMaxCells));
    gridBottom_ = bottom() - kGridMargin;
    columns_ = static_cast<int>(std::ceil(width / cellSize_));
    rows_ = static_cast<int>(std::ceil(height / cellSize_));
    TACTOOTH_ASSERT(columns_ > 0 && rows_ > 0);
    TACTOOTH_ASSERT(columns_ * cellSize_ >= maxRadius_);
    const double halfDiagonal = cellSize_ * std::sqrt(0.5);
    cellStart_.push_back(0);
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            const double r = (column + 0.5) * cellSize_;
            const double z = gridBottom_ + (row + 0.5) * cellSize_;
            const double reach = std::sqrt(nearest(r, z).squaredDistance) + 2 * halfDiagonal + kOnSurface;
            for (const std::uint16_t& index : allSegments_) {
                if (nearest(r, z, &index, &index + 1).squaredDistance <= reach * reach) candidates_.push_back(index);
            }
            cellStart_.push_back(static_cast<std::uint32_t>(candidates_.size()));
        }
    }
}

RevolutionEnvelope::Nearest RevolutionEnvelope::nearest(double radius, double z, const std::uint16_t* first,
                                                        const std::uint16_t* last) const {
    TACTOOTH_ASSERT(first != nullptr && first < last);
    Nearest best{std::numeric_limits<double>::infinity(), 0, 0, 0, false};
    for (const std::uint16_t* index = first; index != last; ++index) {
        const Segment& segment = segments_[*index];
        const double dr = radius - segment.start.radius;
        const double dz = z - segment.start.z;
        const double place = dr * segment.directionR + dz * segment.directionZ;
        const double along = std::clamp(place, 0.0, segment.length);
        const double offsetR = dr - along * segment.directionR;
        const double offsetZ = dz - along * segment.directionZ;
        const double squared = offsetR * offsetR + offsetZ * offsetZ;
        if (squared < best.squaredDistance - kTieTolerance) best = {squared, offsetR, offsetZ, *index, along == place};
    }
    return best;
}

RevolutionEnvelope::Nearest RevolutionEnvelope::nearest(double radius, double z) const {
    TACTOOTH_ASSERT(std::isfinite(radius) && radius >= 0);
    TACTOOTH_ASSERT(std::isfinite(z));
    TACTOOTH_ASSERT(radius / cellSize_ < std::numeric_limits<int>::max());
    const int column = static_cast<int>(radius / cellSize_);
    const double height = (z - gridBottom_) / cellSize_;
    if (column >= columns_ || height < 0 || height >= rows_ || cellStart_.size() <= 1) {
        return nearest(radius, z, allSegments_.data(), allSegments_.data() + allSegments_.size());
    }
    const std::size_t cell = static_cast<std::size_t>(height) * columns_ + column;
    if (cell + 1 >= cellStart_.size()) {
        return nearest(radius, z, allSegments_.data(), allSegments_.data() + allSegments_.size());
    }
    TACTOOTH_ASSERT(cellStart_[cell] < cellStart_[cell + 1] && cellStart_[cell + 1] <= candidates_.size());
    return nearest(radius, z, candidates_.data() + cellStart_[cell], candidates_.data() + cellStart_[cell + 1]);
}

bool RevolutionEnvelope::isInside(double radius, double z) const {
    if (z <= bottom() || z >= top()) return false;
    const auto above = [](double height, const ProfilePoint& point) { return height < point.z; };
    const auto upper = std::upper_bound(profile_.begin(), profile_.end(), z, above);
    TACTOOTH_ASSERT(upper != profile_.begin() && upper != profile_.end());
    const auto lower = upper - 1;
    TACTOOTH_ASSERT(lower->z < upper->z);
    const double t = (z - lower->z) / (upper->z - lower->z);
    return radius < lower->radius + t * (upper->radius - lower->radius);
}

/// If the nearest point lies within a segment, the sign of the offset is the side.
bool RevolutionEnvelope::isInside(const Nearest& hit, double radius, double z) const {
    if (!hit.isWithin || hit.squaredDistance <= kOnSurface * kOnSurface) return isInside(radius, z);
    TACTOOTH_ASSERT(hit.segment < segments_.size());
    const Segment& segment = segments_[hit.segment];
    return hit.offsetR * segment.directionZ - hit.offsetZ * segment.directionR < 0;
}

double RevolutionEnvelope::signedDistance(const Vec3& pointInTool) const {
    TACTOOTH_ASSERT(pointInTool.allFinite());
    const double radius = std::sqrt(pointInTool.x() * pointInTool.x() + pointInTool.y() * pointInTool.y());
    const Nearest hit = nearest(radius, pointInTool.z());
    const double distance = std::sqrt(hit.squaredDistance);
    return isInside(hit, radius, pointInTool.z()) ? -distance : distance;
}

FieldSample RevolutionEnvelope::sample(const Vec3& pointInTool) const {
    TACTOOTH_ASSERT(pointInTool.allFinite());
    const double radius = std::sqrt(pointInTool.x() * pointInTool.x() + pointInTool.y() * pointInTool.y());
    const Nearest hit = nearest(radius, pointInTool.z());
    const double distance = std::sqrt(hit.squaredDistance);
    const Segment& segment = segments_[hit.segment];
    const bool inside = isInside(hit, radius, pointInTool.z());
    double slopeR;
    double slopeZ;
    if (distance > kOnSurface) {
        const double scale = (inside ? -1.0 : 1.0) / distance;
        slopeR = hit.offsetR * scale;
        slopeZ = hit.offsetZ * scale;
    } else {  // the profile runs upward on the outside: its outward normal is the direction turned to the right
        slopeR = segment.directionZ;
        slopeZ = -segment.directionR;
    }
    TACTOOTH_ASSERT(std::abs(slopeR * slopeR + slopeZ * slopeZ - 1) < 1e-6);  // the gradient is a unit vector
    const Vec3 outward = radius > 0 ? Vec3(pointInTool.x() / radius, pointInTool.y() / radius, 0) : Vec3::UnitX();
    return {inside ? -distance : distance, Vec3(slopeR * outward.x(), slopeR * outward.y(), slopeZ)};
}

/// Whether the profile is convex at the end of a segment. The profile runs upward on the outside, so that inward is to
/// the left. On the axis it meets its own mirror image.
bool RevolutionEnvelope::bulgesAfter(std::size_t segment) const {
    TACTOOTH_ASSERT(segment < segments_.size());
    if (segment + 1 == segments_.size()) return true;
    const Segment& before = segments_[segment];
    const Segment& after = segments_[segment + 1];
    return before.directionR * after.directionZ >= before.directionZ * after.directionR;
}

bool RevolutionEnvelope::findPart(const Vec3& pointInTool, double distance, double reach, ProfilePart& part) const {
    TACTOOTH_ASSERT(pointInTool.allFinite() && std::isfinite(distance));
    TACTOOTH_ASSERT(std::isfinite(reach) && reach >= 0);
    const double radius = std::sqrt(pointInTool.x() * pointInTool.x() + pointInTool.y() * pointInTool.y());
    const double z = pointInTool.z();
    const double farthest = std::abs(distance) + 2 * reach;
    const auto topOf = [](const Segment& s) { return s.start.z + s.length * s.directionZ; };
    const auto isBelow = [&](const Segment& s) {
        return topOf(s) < z - farthest;
    };  // heights of the profile never decrease
    const auto first = std::partition_point(segments_.begin(), segments_.end(), isBelow);
    const auto sideAfter = [&](std::size_t segment) { return bulgesAfter(segment) ? 1.0F : -1.0F; };
    part.pieceCount = 0;
    part.bulges = true;
    auto before = segments_.end();
    for (auto s = first; s != segments_.end() && s->start.z <= z + farthest; ++s) {
        const auto index = static_cast<std::uint16_t>(s - segments_.begin());
        if (nearest(radius, z, &index, &index + 1).squaredDistance > farthest * farthest) continue;
        if (part.pieceCount == static_cast<int>(part.pieces.size())) return false;
        const double startR = s->start.radius;
        const double startZ = s->start.z - z;
        const float sideAtStart = index > 0 ? sideAfter(index - 1U) : 1.0F;
        part.pieces[part.pieceCount++] = {static_cast<float>(s->directionR),
                                          static_cast<float>(s->directionZ),
                                          static_cast<float>(-startR * s->directionR - startZ * s->directionZ),
                                          static_cast<float>(startZ * s->directionR - startR * s->directionZ),
                                          static_cast<float>(s->length),
                                          sideAtStart + 2 * sideAfter(index)};
        part.bulges &= before == segments_.end() || (before + 1 == s && bulgesAfter(index - 1U));
        before = s;
    }
    return true;
}

void RevolutionEnvelope::validate() const {
    TACTOOTH_ASSERT(profile_.size() >= 3);
    TACTOOTH_ASSERT(profile_.front().radius < 1e-9 && profile_.back().radius < 1e-9);
    double widest = 0;
    for (std::size_t i = 0; i < profile_.size(); ++i) {
        TACTOOTH_ASSERT(std::isfinite(profile_[i].radius) && profile_[i].radius >= 0);
        TACTOOTH_ASSERT(i == 0 || profile_[i - 1].z <= profile_[i].z);
        widest = std::max(widest, profile_[i].radius);
    }
    TACTOOTH_ASSERT(widest == maxRadius_);
    for (const Segment& segment : segments_) {
        TACTOOTH_ASSERT(segment.length > 0);
        TACTOOTH_ASSERT(std::abs(std::hypot(segment.directionR, segment.directionZ) - 1) < 1e-9);
        TACTOOTH_ASSERT(segment.directionZ >= 0);
    }
    TACTOOTH_ASSERT(allSegments_.size() == segments_.size());
    TACTOOTH_ASSERT(cellStart_.size() == static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1);
    for (std::size_t cell = 0; cell + 1 < cellStart_.size(); ++cell)
        TACTOOTH_ASSERT(cellStart_[cell] < cellStart_[cell + 1]);
    TACTOOTH_ASSERT(cellStart_.back() == candidates_.size());
    for (const std::uint16_t index : candidates_) TACTOOTH_ASSERT(index < segments_.size());
}

}  // namespace tactooth

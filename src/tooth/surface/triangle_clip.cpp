// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/triangle_clip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory_resource>
#include <utility>

#include "geometry/util/assert.h"
#include "tooth/surface/polygon_triangulation.h"

// Source: J. Smith and N. Dodgson, "A topologically robust algorithm for Boolean operations on polyhedral shapes using
// approximate arithmetic", Computer-Aided Design 39, 2007. As there, consistent predicates decide which points exist
// and how they are joined. Coordinates decide only how the resulting polygons are split into triangles. Difference:
// only one triangle is clipped at a time.

namespace tactooth {

int exitSurplus(std::span<const EdgeCrossing> crossings) {
    const auto leaving = std::count_if(crossings.begin(), crossings.end(), [](const auto& c) { return c.leaves; });
    return static_cast<int>(2 * leaving - static_cast<std::ptrdiff_t>(crossings.size()));
}

bool sortCrossings(std::span<EdgeCrossing> crossings, bool firstKept) {
    std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.liesBefore(b); });
    const int surplus = exitSurplus(crossings);
    if (surplus < -1 || surplus > 1) return false;
    bool expected = surplus == 0 ? firstKept : surplus > 0;
    for (auto place = crossings.begin(); place != crossings.end(); ++place, expected = !expected) {
        const auto fitting = std::find_if(place, crossings.end(), [&](const auto& c) { return c.leaves == expected; });
        TACTOOTH_ASSERT(fitting != crossings.end());
        std::rotate(place, fitting, fitting + 1);
    }
    return true;
}

namespace {

class Clipper {
public:
    Clipper(const std::array<Vec3, 3>& corners, const std::vector<ClipSegment>& segments)
        : segments_(segments), lines_(segments.size(), &pool_) {
        startingAt_.reserve(segments.size());
        result_.points.reserve(3 + 2 * segments.size());
        result_.points.assign(corners.begin(), corners.end());
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            TACTOOTH_ASSERT(segments[i].start.edge < 3 && segments[i].end.edge < 3);
            TACTOOTH_ASSERT(segments[i].start.position.allFinite() && segments[i].end.position.allFinite());
            lines_[i].startPoint = static_cast<std::uint32_t>(result_.points.size());
            result_.points.push_back(segments[i].start.position);
            if (segments[i].start.edge < 0) startingAt_.emplace_back(segments[i].start.key, i);
        }
        std::sort(startingAt_.begin(), startingAt_.end());
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            if (segments[i].end.edge < 0) continue;
            lines_[i].endPoint = static_cast<std::uint32_t>(result_.points.size());
            result_.points.push_back(segments[i].end.position);
        }
    }

    std::optional<ClippedTriangle> run(const std::array<bool, 3>& isForward, const std::array<bool, 3>& keepsCorner) {
        if (!buildRing(isForward, keepsCorner)) return std::nullopt;
        if (ring_.size() == 3) {
            if (keepsCorner[0]) outlines_.push_back({0, 1, 2});
        } else if (!traceFromBoundary()) {
            return std::nullopt;
        }
        project();
        if (!traceClosedLines() || !assignHoles()) return std::nullopt;
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            if (outlines_[i].size() < 3) continue;
            TACTOOTH_ASSERT(i < holesOf_.size());
            const auto triangles = triangulate(flat_, std::move(outlines_[i]), std::move(holesOf_[i]));
            result_.triangles.insert(result_.triangles.end(), triangles.begin(), triangles.end());
        }
        return std::move(result_);
    }

private:
    static constexpr std::uint32_t kNoSegment = ~0U;
    using Key = std::array<std::uint64_t, 2>;
    /// State of one segment of a cut line.
    struct Line {
        std::uint32_t startPoint = 0, endPoint = 0;  ///< in the points of the result
        std::size_t endStop = 0;                     ///< on the ring, if the segment ends there
        bool isVisited = false;
    };
    /// A stop on the ring around the triangle, counter-clockwise: a corner, or the start or end of a cut line.
    struct Stop {
        std::uint32_t point;
        std::uint32_t segment;  ///< kNoSegment at a corner
        bool leaves;
    };

    bool buildRing(const std::array<bool, 3>& isForward, const std::array<bool, 3>& keepsCorner) {
        ring_.reserve(3 + 2 * segments_.size());
        crossings_.reserve(2 * segments_.size());
        for (int edge = 0; edge < 3; ++edge) {
            crossings_.clear();
            for (std::uint32_t i = 0; i < segments_.size(); ++i) {
                const auto& [start, end] = segments_[i];
                if (start.edge == edge) crossings_.push_back({start.along, start.crossingFace, isForward[edge], i});
                if (end.edge == edge) crossings_.push_back({end.along, end.crossingFace, !isForward[edge], i});
            }
            if (!sortCrossings(crossings_, keepsCorner[isForward[edge] ? edge : (edge + 1) % 3])) return false;
            if (!isForward[edge]) std::reverse(crossings_.begin(), crossings_.end());
            ring_.push_back({static_cast<std::uint32_t>(edge), kNoSegment, false});
            for (const EdgeCrossing& crossing : crossings_) {
                const bool leaves = crossing.leaves == isForward[edge];
                const std::uint32_t i = crossing.segment;
                if (!leaves) lines_[i].endStop = ring_.size();
                ring_.push_back({leaves ? lines_[i].startPoint : lines_[i].endPoint, i, leaves});
            }
        }
        return true;
    }

    /// Moves on to the segment that starts where `segment` ends. False if there is none.
    bool advance(std::uint32_t& segment) const {
        TACTOOTH_ASSERT(segment < segments_.size() && segments_[segment].end.edge < 0);
        const Key& key = segments_[segment].end.key;
        const auto beyond = std::upper_bound(startingAt_.begin(), startingAt_.end(), std::pair(key, kNoSegment));
        if (beyond == startingAt_.begin() || (beyond - 1)->first != key) return false;
        segment = (beyond - 1)->second;
        return true;
    }

    /// Follows a cut line to its end on the ring. False if the line is interrupted.
    bool followLine(std::uint32_t& segment, PolygonLoop& loop) {
        for (;;) {
            if (lines_[segment].isVisited) return false;
            lines_[segment].isVisited = true;
            loop.push_back(lines_[segment].startPoint);
            if (segments_[segment].end.edge >= 0) return true;
            if (!advance(segment)) return false;
        }
    }

    bool traceFromBoundary() {
        for (const Stop& stop : ring_) {
            if (stop.segment == kNoSegment || !stop.leaves || lines_[stop.segment].isVisited) continue;
            PolygonLoop loop;
            loop.reserve(ring_.size());
            std::uint32_t segment = stop.segment;
            do {
                if (!followLine(segment, loop)) return false;
                TACTOOTH_ASSERT(lines_[segment].endPoint >= 3 && lines_[segment].endStop < ring_.size());
                loop.push_back(lines_[segment].endPoint);
                std::size_t place = (lines_[segment].endStop + 1) % ring_.size();
                for (; ring_[place].segment == kNoSegment; place = (place + 1) % ring_.size()) {
                    loop.push_back(ring_[place].point);
                }
                if (!ring_[place].leaves) return false;
                segment = ring_[place].segment;
            } while (segment != stop.segment);
            outlines_.push_back(std::move(loop));
        }
        return true;
    }

    bool traceClosedLines() {
        for (std::uint32_t first = 0; first < segments_.size(); ++first) {
            if (lines_[first].isVisited) continue;
            PolygonLoop loop;
            std::uint32_t segment = first;
            do {
                if (lines_[segment].isVisited || segments_[segment].end.edge >= 0) return false;
                lines_[segment].isVisited = true;
                loop.push_back(lines_[segment].startPoint);
                if (!advance(segment)) return false;
            } while (segment != first);
            (doubledArea(flat_, loop) >= 0 ? outlines_ : holes_).push_back(std::move(loop));
        }
        return true;
    }

    bool assignHoles() {
        holesOf_.resize(outlines_.size());
        for (PolygonLoop& hole : holes_) {
            if (outlines_.empty()) return false;
            TACTOOTH_ASSERT(hole.size() >= 3);
            std::size_t owner = 0;
            for (std::size_t i = 0; i < outlines_.size(); ++i) {
                if (isWithin(flat_, outlines_[i], flat_[hole.front()])) owner = i;
            }
            holesOf_[owner].push_back(std::move(hole));
        }
        return true;
    }

    /// Drops the axis in which the triangle's normal is longest, and keeps the orientation.
    void project() {
        const auto& p = result_.points;
        const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
        Eigen::Index axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        int u = static_cast<int>(axis + 1) % 3;
        int v = static_cast<int>(axis + 2) % 3;
        if (normal[axis] < 0) std::swap(u, v);
        flat_.reserve(p.size());
        for (const Vec3& point : p) flat_.emplace_back(point[u], point[v]);
        TACTOOTH_ASSERT(flat_.size() == p.size());
    }

    const std::vector<ClipSegment>& segments_;
    std::array<std::byte, 4096> memory_;  // enough for nearly every triangle; the rest comes from the heap
    std::pmr::monotonic_buffer_resource pool_{memory_.data(), memory_.size()};
    std::pmr::vector<Line> lines_;
    ClippedTriangle result_;
    std::pmr::vector<std::pair<Key, std::uint32_t>> startingAt_{&pool_};  // segments that start inside, ordered by key
    std::pmr::vector<EdgeCrossing> crossings_{&pool_};                    // of the current edge
    std::pmr::vector<Stop> ring_{&pool_};
    std::pmr::vector<PolygonLoop> outlines_{&pool_}, holes_{&pool_};
    std::pmr::vector<std::vector<PolygonLoop>> holesOf_{&pool_};
    std::vector<Vec2> flat_;
};

}  // namespace

std::optional<ClippedTriangle> clipTriangle(const std::array<Vec3, 3>& corners, const std::array<bool, 3>& isForward,
                                            const std::vector<ClipSegment>& segments,
                                            const std::array<bool, 3>& keepsCorner) {
    TACTOOTH_ASSERT(corners[0].allFinite() && corners[1].allFinite() && corners[2].allFinite());
    return Clipper(corners, segments).run(isForward, keepsCorner);
}

}  // namespace tactooth

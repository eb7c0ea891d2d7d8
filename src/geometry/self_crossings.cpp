// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/self_crossings.h"

#include <algorithm>

#include "geometry/parallel_for.h"
#include "geometry/triangle_crossing.h"

namespace tactooth {
namespace {

class CrossingFinder {
public:
    explicit CrossingFinder(const TriangleMesh& mesh) : mesh_(mesh) { fillCells(); }
    [[nodiscard]] std::vector<std::uint32_t> crossing() const;

private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t triangle;
        auto operator<=>(const Entry&) const = default;
    };
    [[nodiscard]] Box3 boxOf(std::uint32_t t) const {
        Box3 box;
        for (int i = 0; i < 3; ++i) box.extend(mesh_.corner(t, i));
        return box;
    }
    void fillCells();

    const TriangleMesh& mesh_;
    std::vector<Box3> boxes_;
    std::vector<Entry> entries_;  // by cell
};

/// Each triangle in all cells of a regular grid that its box reaches into.
void CrossingFinder::fillCells() {
    Box3 all;
    double sum = 0;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const Box3 box = boxOf(t);
        boxes_.emplace_back(box.min().array() - kCrossingDistance, box.max().array() + kCrossingDistance);
        all.extend(boxes_.back());
        sum += boxes_.back().sizes().maxCoeff();
    }
    if (boxes_.empty()) return;
    constexpr double kBits = 1 << 20;  // cells along an axis that a number of a cell has room for
    const double size = std::max(sum / static_cast<double>(boxes_.size()), all.sizes().maxCoeff() / kBits);
    if (size <= 0) return;
    const auto cellOf = [&](const Vec3& p) { return Eigen::Vector3i(((p - all.min()) / size).cast<int>()); };
    for (std::uint32_t t = 0; t < boxes_.size(); ++t) {
        const Eigen::Vector3i low = cellOf(boxes_[t].min()), high = cellOf(boxes_[t].max());
        for (int x = low.x(); x <= high.x(); ++x) {
            for (int y = low.y(); y <= high.y(); ++y) {
                for (int z = low.z(); z <= high.z(); ++z) {
                    entries_.push_back({(std::uint64_t(x) << 42) | (std::uint64_t(y) << 21) | std::uint64_t(z), t});
                }
            }
        }
    }
    std::ranges::sort(entries_);
}

std::vector<std::uint32_t> CrossingFinder::crossing() const {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (i == 0 || entries_[i].cell != entries_[i - 1].cell) begins.push_back(i);
    }
    begins.push_back(entries_.size());
    std::vector<std::vector<std::uint32_t>> found(begins.size() - 1);
    parallelFor(found.size(), [&](std::size_t cell) {
        for (std::size_t i = begins[cell]; i < begins[cell + 1]; ++i) {
            for (std::size_t k = i + 1; k < begins[cell + 1]; ++k) {
                const std::uint32_t a = entries_[i].triangle, b = entries_[k].triangle;
                if (!boxes_[a].intersects(boxes_[b]) || !trianglesCross(mesh_, a, b)) continue;
                found[cell].push_back(a);
                found[cell].push_back(b);
            }
        }
    });
    std::vector<std::uint32_t> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

std::vector<std::uint32_t> selfCrossings(const TriangleMesh& mesh) { return CrossingFinder(mesh).crossing(); }

bool untangle(TriangleMesh& mesh, const std::vector<Vec3f>& home) {
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        const std::vector<std::uint32_t> crossing = selfCrossings(mesh);
        if (crossing.empty()) return true;
        std::vector<std::uint8_t> goes(mesh.vertices.size(), 0);
        for (const std::uint32_t t : crossing) {
            for (const std::uint32_t vertex : mesh.triangles[t]) goes[vertex] = 1;
        }
        for (int ring = 0; ring < round; ++ring) {
            std::vector<std::uint8_t> wider = goes;
            for (const Triangle& t : mesh.triangles) {
                if ((goes[t[0]] | goes[t[1]] | goes[t[2]]) == 0) continue;
                for (const std::uint32_t vertex : t) wider[vertex] = 1;
            }
            goes.swap(wider);
        }
        for (std::size_t i = 0; i < goes.size(); ++i) {
            if (goes[i] != 0) mesh.vertices[i] = home[i];
        }
    }
    return selfCrossings(mesh).empty();
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

/// What the cut lines that cross an edge decide about its two ends.
struct EdgeEnds {
    bool firstKept;
    bool secondKept;
    double weight;  ///< certainty: see VertexGroups::report
};

/// Groups of vertices that no cut line separates: union-find with path halving (R. Tarjan, "Efficiency of a Good But
/// Not Linear Set Union Algorithm", 1975). Either all vertices of a group are kept or none. The most certain statement
/// about one of its vertices decides for the group: cut lines that separate it from another group, else the largest
/// distance.
class VertexGroups {
public:
    /// The weight of a statement by cut lines that separate two vertices. Larger than any distance.
    static constexpr double kCertain = 1e9;

    explicit VertexGroups(std::size_t count) : parent_(count), known_(count), weight_(count, -1.0) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a == b) return;
        if (b < a) std::swap(a, b);
        parent_[b] = a;
        if (weight_[b] > weight_[a]) weight_[a] = weight_[b], known_[a] = known_[b];
    }
    /// Adds a statement about a vertex. `weight`: its certainty, the distance from the cut in mm. Of two equal weights
    /// the first one counts.
    void report(std::uint32_t vertex, bool kept, double weight) {
        TACTOOTH_ASSERT(weight >= 0);
        const std::uint32_t group = find(vertex);
        if (weight > weight_[group]) weight_[group] = weight, known_[group] = kept;
    }
    /// Adds an edge: its ends belong to one group unless cut lines separate them.
    void addEdge(std::uint32_t first, std::uint32_t second, const std::optional<EdgeEnds>& ends) {
        if (!ends || ends->firstKept == ends->secondKept) join(first, second);
        if (!ends) return;
        report(first, ends->firstKept, ends->weight);
        report(second, ends->secondKept, ends->weight);
    }
    [[nodiscard]] std::optional<bool> isKept(std::uint32_t vertex) {
        const std::uint32_t group = find(vertex);
        if (weight_[group] < 0) return std::nullopt;
        return known_[group];
    }

private:
    std::uint32_t find(std::uint32_t vertex) {
        TACTOOTH_ASSERT(vertex < parent_.size());
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }
    std::vector<std::uint32_t> parent_;
    std::vector<bool> known_;
    std::vector<double> weight_;
};

}  // namespace tactooth

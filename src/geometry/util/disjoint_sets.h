// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

/// Disjoint sets of the elements 0..n-1. R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm",
/// Journal of the ACM 22, 1975, with path halving. Ours differs in one point: the smallest member represents a set, so
/// that the result does not depend on the order of `join`.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

    /// The smallest member of the set of `member`, which is less than the count.
    std::uint32_t find(std::uint32_t member) {
        TACTOOTH_ASSERT(member < parent_.size());
        while (parent_[member] != member) {
            parent_[member] = parent_[parent_[member]];
            member = parent_[member];
        }
        return member;
    }

    /// Unites the sets of two elements.
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        if (a > b) std::swap(a, b);
        TACTOOTH_ASSERT(a <= b);
        parent_[b] = a;
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/mesh/corner_shading.h"

namespace tactooth {

/// How much of each tag there is at a point.
class TagShares {
public:
    void clear() { shares_.clear(); }
    void add(SurfaceTag tag, float weight) {
        const auto known = std::find_if(shares_.begin(), shares_.end(), [&](const auto& s) { return s.tag == tag; });
        if (known != shares_.end()) {
            known->weight += weight;
        } else {
            shares_.push_back({tag, weight});
        }
    }
    [[nodiscard]] LookMix mix() {
        std::sort(shares_.begin(), shares_.end(), [](const Share& a, const Share& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.tag < b.tag;
        });
        if (shares_.empty()) return {};
        if (shares_.size() == 1) return {shares_[0].tag, shares_[0].tag, 0};
        const float both = shares_[0].weight + shares_[1].weight;
        const float share = both > 0 ? shares_[1].weight / both : 0;
        return {shares_[0].tag, shares_[1].tag, static_cast<std::uint8_t>(std::lround(255 * share))};
    }

private:
    struct Share {
        SurfaceTag tag;
        float weight;
    };
    std::vector<Share> shares_;
};

}  // namespace tactooth

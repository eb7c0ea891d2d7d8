// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "view/mesh/corner_shading.h"

namespace tactooth {

/// The weight of each tag at a point.
class TagWeights {
public:
    void clear() { weights_.clear(); }
    void add(SurfaceTag tag, float weight) {
        const auto known = std::find_if(weights_.begin(), weights_.end(), [&](const auto& s) { return s.tag == tag; });
        if (known != weights_.end()) {
            known->weight += weight;
        } else {
            weights_.push_back({tag, weight});
        }
    }
    [[nodiscard]] AppearanceMix mix() {
        std::sort(weights_.begin(), weights_.end(), [](const Share& a, const Share& b) {
            return a.weight != b.weight ? a.weight > b.weight : a.tag < b.tag;
        });
        if (weights_.empty()) return {};
        if (weights_.size() == 1) return {weights_[0].tag, weights_[0].tag, 0};
        const float both = weights_[0].weight + weights_[1].weight;
        const float share = both > 0 ? weights_[1].weight / both : 0;
        return {weights_[0].tag, weights_[1].tag, static_cast<std::uint8_t>(std::lround(255 * share))};
    }

private:
    struct Share {
        SurfaceTag tag;
        float weight;
    };
    std::vector<Share> weights_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>

#include "geometry/util/assert.h"
#include "view/gl/render_target.h"

namespace tactooth {

/// A render target that is made again only when its size or its number of samples changes.
class ReusableTarget {
public:
    Expected<const RenderTarget*> fit(ImageSize size, int samples) {
        if (!target_ || target_->size() != size || asked_ != samples) {
            target_.reset();
            auto made = RenderTarget::create(size, samples);
            if (!made) return Unexpected{made.error()};
            target_ = std::move(*made);
            asked_ = samples;
        }
        return &*target_;
    }
    /// What `fit` has made.
    [[nodiscard]] const RenderTarget& target() const { return TACTOOTH_ASSERT(target_), *target_; }

private:
    std::optional<RenderTarget> target_;
    int asked_ = 0;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/common/scene_builder.h"

namespace tactooth {

/// The centre of the tooth's box in x and y, just below its top: close enough to the crown of any tooth.
[[nodiscard]] Vec3 crownOf(const Surface& tooth);

/// Says what stands between the eye and what a dentist works on: the crown with its surroundings, the bur's tip, the
/// mirror. `contents` outlives it.
class Obstacles {
public:
    explicit Obstacles(const SceneContents& contents);

    /// Whether the other side of the same jaw stands there.
    [[nodiscard]] bool isBeyondHidden() const { return isBeyondHidden_; }
    /// Whether a soft tissue stands there, or belongs to the other side of the jaw and that is left out.
    [[nodiscard]] bool hides(const ShownTissue& tissue) const;

private:
    /// The nearest front face of a body before a place of work.
    struct Obstacle {
        Vec3 point;
        double before = 0;  ///< mm from there to the place
    };
    [[nodiscard]] std::optional<Obstacle> before(const Vec3& place, const Surface& body) const;
    [[nodiscard]] bool hidesFromBeyond(const ShownBody& body) const;

    Vec3 eye_;
    std::vector<Vec3> places_;      // of work
    std::optional<Plane> midline_;  // of the jaw, positive on the own side
    bool isBeyondHidden_ = false;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "collision/bvh/surface.h"
#include "geometry/util/pose.h"
#include "instruments/mirror.h"
#include "session/hands/pointer_view.h"

namespace tactooth {

// All in the tooth's frame, mm.

/// The glass of a mirror that is held at `mirror`.
[[nodiscard]] MirrorDisc glassAt(const MirrorDisc& disc, const Pose& mirror);

/// The image of `place` in the plane of the glass.
[[nodiscard]] Vec3 mirrorImage(const MirrorDisc& glass, const Vec3& place);

/// The distance along `ray` to the glass, from either side; none beside it.
[[nodiscard]] std::optional<double> meetingWith(const MirrorDisc& glass, const Ray& ray);

/// The picture as a mirror shows it. A line of sight begins where the glass, or its plane beside it, reflects it.
class MirrorView final : public PointerView {
public:
    /// `picture` outlives it.
    MirrorView(const PointerView& picture, const MirrorDisc& glass) : picture_(picture), glass_(glass) {}

    [[nodiscard]] Ray rayThrough(const Vec2& pixel) const override;
    [[nodiscard]] Mat3 eyeAxes() const override;

private:
    const PointerView& picture_;
    MirrorDisc glass_;
};

/// Whether the picture shows the reflecting side of the glass at `pixel`: no part of `mouth` is before it. Instruments
/// do not count: the mouse points past them, as it does on the tooth.
[[nodiscard]] bool showsGlass(const PointerView& picture, const Vec2& pixel, const MirrorDisc& glass,
                              const Surface& mouth);

/// Whether nothing of `mouth` is between the eye and the image of `place` at `pixel`: neither before the glass nor
/// between the glass and the place.
[[nodiscard]] bool isSeenInMirror(const PointerView& picture, const Vec2& pixel, const MirrorDisc& glass,
                                  const Vec3& place, const Surface& mouth);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "view/camera/camera.h"

namespace tactooth {

/// The standard dental views of a tooth whose frame is +z to the crown, +y buccal, and mesial along +x or -x.
enum class StandardView { Occlusal, Buccal, Lingual, Mesial, Distal };

/// A camera that the user moves around a target point. +z of the world stays upright in the picture. The eye may be
/// exactly above or below the target (occlusal view) without a jump.
class OrbitCamera {
public:
    /// The eye's position on the sphere around the target, rad. Azimuth 0 is at +x, azimuth 90 degrees at +y (buccal);
    /// elevation 90 degrees is at +z (occlusal).
    struct Direction {
        double azimuth = 0;
        double elevation = 0;
    };

    /// Fits all of `box` (world, mm) into the picture, whatever its rotation. The direction stays the same.
    void fit(const Box3& box, double aspect);
    /// Centres `points` (world, mm) and lets them fill `share` (0..1) of the picture's height or width, whichever they
    /// reach first. The direction stays the same. Without points nothing changes.
    void fill(std::span<const Vec3> points, double share, double aspect);
    /// Sets a standard view; target and distance stay. The crown is up in the views from a side. From occlusal the
    /// picture is as if the eye had leaned over from buccal: left and right stay. `mesialX`: 1 where mesial is +x, -1
    /// where it is -x.
    void setView(StandardView view, double mesialX = 1);
    void setView(Direction direction);

    /// Rotates the object by a drag of (dx, dy) pixels: half a picture height rotates it by 90 degrees.
    void orbit(const Vec2& pixels, ImageSize size);
    /// Shifts the picture so that points at the target's depth follow the mouse.
    void pan(const Vec2& pixels, ImageSize size);
    /// Moves closer (factor < 1) or back (> 1). The point under `pixel` at the target's depth stays there.
    void zoom(double factor, const Vec2& pixel, ImageSize size);
    /// Makes `point` (world) the pivot of the camera. The picture does not jump: the eye and its direction stay.
    void setPivot(const Vec3& point);

    /// Moves `point` (world) to the centre of the picture; direction and distance stay.
    void centreOn(const Vec3& point) { target_ = point; }

    [[nodiscard]] Camera camera() const;
    [[nodiscard]] const Vec3& target() const { return target_; }
    [[nodiscard]] double distance() const { return distance_; }
    [[nodiscard]] Direction direction() const { return direction_; }
    /// Size of one pixel at the target's depth, mm.
    [[nodiscard]] double pixelPitch(ImageSize size) const;

private:
    [[nodiscard]] Quat rotation() const;

    Vec3 target_ = Vec3::Zero();
    double distance_ = 60;     ///< mm
    double sceneRadius_ = 60;  ///< mm: everything of interest is within this distance of the target
    Direction direction_{1.2, 0.5};
};

/// The same view of a tooth mirrored in x, that is, of the same tooth on the other side of the mouth.
[[nodiscard]] OrbitCamera::Direction mirroredInX(OrbitCamera::Direction direction);

}  // namespace tactooth

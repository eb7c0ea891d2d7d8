// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "view/camera/camera.h"

namespace tactooth {

/// The standard dental views of a tooth whose frame is +z to the crown, +y buccal, and mesial along +x or -x.
enum class StandardView { Occlusal, Buccal, Lingual, Mesial, Distal };

/// A camera that a person moves around a point of interest. +z of the world stays upright in the picture; the eye
/// may stand exactly above or below (occlusal view) without a jump.
class OrbitCamera {
public:
    /// The eye's place on the sphere around the target, rad: azimuth 0 looks from +x, 90 degrees from +y
    /// (buccal); elevation 90 degrees looks from +z (occlusal).
    struct Direction {
        double azimuth = 0;
        double elevation = 0;
    };

    /// Shows `box` (world, mm) whole from the same direction, whatever way it is turned.
    void fit(const Box3& box, double aspect);
    /// Turns to a standard view; target and distance stay. `mesialX`: 1 where mesial is +x, -1 where it is -x.
    void setView(StandardView view, double mesialX = 1);
    void setView(Direction direction);

    /// Drags the object by (dx, dy) pixels: half a picture height turns it by 90 degrees.
    void orbit(const Vec2& pixels, ImageSize size);
    /// Shifts the picture so that what lies at the target's depth follows the mouse.
    void pan(const Vec2& pixels, ImageSize size);
    /// Comes nearer (factor < 1) or goes back (> 1); what lies under `pixel` at the target's depth stays there.
    void zoom(double factor, const Vec2& pixel, ImageSize size);
    /// Makes `point` (world) what the camera turns around; the picture does not jump: the eye and its direction stay.
    void setPivot(const Vec3& point);

    /// Brings `point` (world) to the middle of the picture; direction and distance stay.
    void centreOn(const Vec3& point) { target_ = point; }

    [[nodiscard]] Camera camera() const;
    [[nodiscard]] const Vec3& target() const { return target_; }
    [[nodiscard]] double distance() const { return distance_; }
    [[nodiscard]] Direction direction() const { return direction_; }
    /// mm that one pixel covers at the target's depth.
    [[nodiscard]] double pixelPitch(ImageSize size) const;

private:
    [[nodiscard]] Quat rotation() const;

    Vec3 target_ = Vec3::Zero();
    double distance_ = 60;     ///< mm
    double sceneRadius_ = 60;  ///< mm: everything of interest lies this near to the target
    Direction direction_{1.2, 0.5};
};

/// The same view of a tooth that is mirrored in x: of the same tooth on the other side of the mouth.
[[nodiscard]] OrbitCamera::Direction mirroredInX(OrbitCamera::Direction direction);

}  // namespace tactooth

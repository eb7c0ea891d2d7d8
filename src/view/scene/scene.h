// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "collision/bvh/surface.h"
#include "geometry/mesh/triangle_mesh.h"
#include "view/camera/camera.h"
#include "view/camera/second_view.h"
#include "view/camera/stereo.h"
#include "view/mesh/distance_grid.h"
#include "view/scene/appearance.h"
#include "view/scene/particle.h"

namespace tactooth {

/// A shape to draw: a plain surface, or a tooth that is being cut. The renderer keeps what it uploads for a shape as
/// long as later scenes hold the same pointer (or, for a tooth, later snapshots of the same surface).
using SceneShape = std::variant<std::shared_ptr<const TriangleMesh>, std::shared_ptr<const Surface>>;

/// One thing in the picture.
struct SceneObject {
    SceneShape shape;
    Pose objectInWorld;
    double spin = 0;  ///< rad, about the object's own z axis, before objectInWorld: a turning bur
    std::vector<Appearance> appearances = {
        Appearance{}};  ///< one a surface tag; tags beyond the last use the last. At most kMaxAppearances
    bool visible = true;
    bool closed = true;      ///< the surface has no holes, so that what looks away need not be drawn
    bool moves = false;      ///< a tool: its shadow is drawn anew in each picture, that of the others only on change
    bool handle = false;     ///< of an instrument: left out of the second view, where it would hide the tooth
    bool sectioned = false;  ///< the scene's section takes its part of it away
    std::optional<Appearance>
        capAppearance;  ///< what a section through it shows; without one it is hollow. Needs `closed`
    /// What fills a body from inside, a layer of a tooth: seen only where that body (the first sectioned object) still
    /// is, so that nothing of it stands in a cavity. One that is not visible still shows in the section.
    bool inner = false;
    /// The wall of a hollow that is to be: seen through sectioned objects as tinted glass, whatever is before it of
    /// them. Throws no shadow.
    bool ghost = false;
    std::optional<DistanceColourMap> distances;  ///< replaces the colours of the looks
};
inline constexpr std::size_t kMaxAppearances = 8;

/// A round flat mirror that shows the scene in front of it.
struct SceneMirror {
    Pose mirrorInWorld;
    Vec3 centre = Vec3::Zero();   ///< mirror frame, mm
    Vec3 normal = Vec3::UnitZ();  ///< mirror frame, unit; the side that reflects
    double radius = 11;           ///< mm; 11 is the usual mirror size 4 (22 mm)
    float reflectance = 0.93F;    ///< 0..1, of rhodium front coating
    float fog = 0;                ///< 0..1: breath on the glass
    float drops = 0;              ///< 0..1: share of the glass where drops of spray stand

    [[nodiscard]] Plane planeInWorld() const;
};

/// A look inside: what lies on the positive side of `plane` (world) is taken away from the sectioned objects.
struct Section {
    Plane plane;
};

/// Light of the dental unit. Directions point from the scene to the light, world frame, unit. Colours are linear.
struct Lighting {
    Vec3 toKey = Vec3(0.35, 0.45, 0.82).normalized();  ///< the operating light; it throws the shadows
    Vec3f keyColour = Vec3f(1.14F, 1.10F, 1.035F);     ///< about 5000 K
    Vec3 toFill = Vec3(-0.5, 0.4, 0.3).normalized();   ///< a weak light without shadow that opens dark sides
    Vec3f fillColour = Vec3f(0.10F, 0.115F, 0.14F);
    Vec3f skyColour = Vec3f(0.27F, 0.28F, 0.30F);       ///< from above
    Vec3f groundColour = Vec3f(0.085F, 0.075F, 0.07F);  ///< from below
};

/// The operating light stands over the dentist's shoulder: to the upper left of the eye, as that light is swung to
/// follow the view; the fill light comes from the lower right.
[[nodiscard]] Lighting operatingLight(const Camera& camera);

/// What is seen where there is nothing.
struct Background {
    enum class Kind {
        Gradient,     ///< `bottom` to `top` over the picture
        Environment,  ///< the surgery that metal and mirrors reflect
        Transparent,  ///< opacity 0
    };
    Kind kind = Kind::Gradient;
    Vec3f top = Vec3f(0.20F, 0.235F, 0.275F);    ///< sRGB
    Vec3f bottom = Vec3f(0.62F, 0.655F, 0.69F);  ///< sRGB
};

/// All that a picture shows. Plain data, filled by the caller and only read by the renderer.
struct Scene {
    std::vector<SceneObject> objects;  ///< of those that are transparent, outer ones before what is inside them
    std::optional<SceneMirror> mirror;
    std::optional<Section> section;
    std::vector<Particle> particles;  ///< water, chips; drawn over what is behind them, never in the mirror's plane
    Stereo stereo;
    Camera camera;
    std::optional<SecondView> second;
    Lighting lighting;
    Background background;
};

/// The box of all visible objects, world frame; empty if there are none.
[[nodiscard]] Box3 boundingBox(const Scene& scene);

}  // namespace tactooth

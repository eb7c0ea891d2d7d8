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
#include "tooth/model/material.h"
#include "view/camera/camera.h"
#include "view/camera/second_view.h"
#include "view/camera/stereo.h"
#include "view/mesh/appearance_zones.h"
#include "view/mesh/distance_colour.h"
#include "view/scene/appearance.h"
#include "view/scene/particle.h"
#include "view/scene/surface_liquids.h"

namespace tactooth {

/// A shape to draw: a plain surface, or a tooth that is being cut. The renderer keeps the uploaded data of a shape as
/// long as later scenes hold the same pointer (or, for a tooth, later snapshots of the same surface).
using SceneShape = std::variant<std::shared_ptr<const TriangleMesh>, std::shared_ptr<const Surface>>;

/// One object of the scene.
struct SceneObject {
    SceneShape shape;
    Pose objectInWorld;
    double spin = 0;  ///< rad, about the object's own z axis, before objectInWorld: a rotating bur
    std::vector<Appearance> appearances = {Appearance{}};  ///< one per surface tag, then those that only `zones` uses;
                                                           ///< higher tags use the last one. At most kMaxAppearances
    /// How the appearances pass into each other where tags do not say it; null: they do. The same for all scenes that
    /// hold the same shape.
    std::shared_ptr<const AppearanceZones> zones = {};
    bool visible = true;
    bool closed = true;  ///< the surface has no holes, so back faces need not be drawn
    bool moves = false;  ///< a tool: its shadow is drawn in each frame, that of other objects only on change
    /// Part of an instrument: left out of the second view, where it would hide the tooth. Throws no shadow: an
    /// operating light is several times as wide, so that at its distance from the tooth little is left of a shadow.
    bool handle = false;
    /// What surrounds the scene: left out of the second view. Throws no shadow, and the shadow map does not cover it.
    bool backdrop = false;
    bool sectioned = false;  ///< the scene's section removes a part of it
    std::optional<Appearance>
        capAppearance;  ///< of its section cap; without it the section shows a hollow body. Needs `closed`
    /// A layer of a tooth, inside a body. It is visible only where that body (the first sectioned object) still exists,
    /// so that no part of it is visible in a cavity. An inner object that is not visible still appears in the section.
    bool inner = false;
    /// The wall of a cavity to be cut. It is visible through sectioned objects as tinted glass, whatever part of them
    /// is in front of it. Throws no shadow.
    bool ghost = false;
    std::optional<DistanceColourMap> distances;  ///< replaces the colours of the appearances
    /// The part above this height along the object's own z axis, mm, turns to glass where it hides Scene::sight from
    /// the eye; kAllGlass: all of it. Nothing: it stays solid.
    std::optional<float> glassAbove;
    /// Above this height along the object's own z axis, mm, more than 0, the second appearance takes the place of those
    /// of the tags: the shank of a bur. Nothing: nowhere.
    std::optional<float> secondAbove = {};
    SurfaceLiquids liquids = {};  ///< on its surface
};
inline constexpr float kAllGlass = -1e9F;
[[nodiscard]] inline bool throwsShadow(const SceneObject& object) {
    return !object.ghost && !object.handle && !object.backdrop;
}
/// One for each material of a tooth, and some for the zones between them.
inline constexpr std::size_t kMaxAppearances = kMaxMaterials + 8;

/// A round flat mirror that reflects the scene in front of it.
struct SceneMirror {
    Pose mirrorInWorld;
    Vec3 centre = Vec3::Zero();   ///< mirror frame, mm
    Vec3 normal = Vec3::UnitZ();  ///< mirror frame, unit; points to the reflecting side
    double radius = 11;           ///< mm; 11 is the usual mirror size 4 (22 mm)
    float reflectance = 0.93F;    ///< 0..1, of a rhodium front coating
    float fog = 0;                ///< 0..1: condensed breath on the glass
    float drops = 0;              ///< 0..1: share of the glass that drops of spray cover
    float dirt = 0;               ///< 0..1: dried slurry and dust, which take up to a third of the light

    [[nodiscard]] Plane planeInWorld() const;
    /// The share of the light that comes back from the glass as it is, 0..1.
    [[nodiscard]] float dimmedReflectance() const;
};

/// A section of the scene: removes the parts of sectioned objects on the positive side of `plane` (world).
struct Section {
    Plane plane;
};

/// A straight line that must stay in sight, whatever instrument is before it; world, mm.
struct SightLine {
    Vec3 start, end;
    double radius = 1;  ///< around the line, that must be seen too
};

/// Light of the dental unit. Directions point from the scene to the light, world frame, unit vectors. Colours are
/// linear.
struct Lighting {
    Vec3 toKey = Vec3(0.35, 0.45, 0.82).normalized();  ///< the operating light; it throws the shadows
    Vec3f keyColour = Vec3f(1.10F, 1.065F, 1.005F);    ///< about 5000 K
    Vec3 toFill = Vec3(-0.5, 0.4, 0.3).normalized();   ///< a weak light without shadow that brightens dark sides
    Vec3f fillColour = Vec3f(0.10F, 0.115F, 0.14F);
    Vec3f skyColour = Vec3f(0.31F, 0.305F, 0.30F);      ///< from above
    Vec3f groundColour = Vec3f(0.14F, 0.115F, 0.105F);  ///< from below: lips and cheeks
};

/// The operating light is over the dentist's shoulder, to the upper left of the eye, as a dentist adjusts that light to
/// the view. The fill light comes from the lower right.
[[nodiscard]] Lighting operatingLight(const Camera& camera);

/// The background behind all objects.
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

/// Everything that a picture shows. Plain data that the caller fills and the renderer only reads.
struct Scene {
    std::vector<SceneObject> objects;  ///< transparent ones: outer objects before the objects inside them
    std::optional<SceneMirror> mirror;
    std::optional<Section> section;
    std::optional<SightLine> sight;   ///< what hides it turns to glass (SceneObject::glassAbove)
    std::vector<Particle> particles;  ///< water, chips; drawn over objects behind them, never in the mirror's plane
    Stereo stereo;
    Camera camera;
    std::optional<SecondView> second;
    std::optional<Vec3> magnified;  ///< the place that the magnifier shows, world; none in stereo
    Lighting lighting;
    Background background;
};

/// The box of all visible objects, world frame; empty if there are none.
[[nodiscard]] Box3 boundingBox(const Scene& scene);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "instruments/bur_catalogue.h"
#include "instruments/bur_head.h"
#include "instruments/mirror.h"
#include "session/hands/instrument_poses.h"
#include "tooth/model/material_registry.h"
#include "view/mesh/appearance_zones.h"
#include "view/scene/scene.h"

namespace tactooth {

/// The cutting instrument as it is drawn. Meshes in the tool frame (tip at the origin, +z along the shaft).
struct ShownTool {
    std::shared_ptr<const TriangleMesh> bur;
    std::shared_ptr<const TriangleMesh> turbine;  ///< null: only the bur
    BurMaterial material = BurMaterial::Carbide;
    Pose toolInTooth;
    double spin = 0;  ///< of the bur about its axis, rad
    double speedRpm = 0;
    BurEdge edge = {};
    std::shared_ptr<const TriangleMesh> blurred =
        {};             ///< the appearance of the bur at high speed (spinEnvelopeMesh), or null
    BurHead head = {};  ///< of `bur`; unknown: only the handpiece turns to glass
    std::shared_ptr<const TriangleMesh> cap = {};  ///< headCap: shows the head solid where the neck is glass; or null
    std::optional<Vec3> heading =
        {};  ///< unit, tooth frame: the direction in which the hand will press; none: along the shaft
};

/// The mirror as it is drawn.
struct ShownMirror {
    std::shared_ptr<const TriangleMesh> mesh;  ///< mirror frame
    MirrorDisc disc;
    Pose mirrorInTooth;
    float fog = 0, drops = 0, dirt = 0;  ///< on the glass, as in SceneMirror
};

/// The suction tube as it is drawn.
struct ShownSuction {
    std::shared_ptr<const TriangleMesh> mesh;  ///< from makeSuctionTube
    Pose tubeInTooth;
};

/// A body that stands around the tooth: a neighbour, the gingiva.
struct ShownBody {
    std::shared_ptr<const TriangleMesh> mesh;
    Pose bodyInTooth;
    std::vector<Appearance> appearances;
    std::shared_ptr<const AppearanceZones> zones = {};  ///< as in SceneObject
    bool opposite = false;  ///< part of the opposite jaw: left out where it would stand between the eye and the tooth
    /// On the other side of the same jaw: all these bodies are left out together where one of them would stand between
    /// the eye and the tooth. Of a body that reaches over the midline, the half on the own side is shown then.
    struct Beyond {
        std::shared_ptr<const SurfacePart> surface;         ///< to see whether it stands there; tooth frame
        std::optional<Plane> midline = {};                  ///< positive on the own side; none: all of it is beyond
        std::shared_ptr<const TriangleMesh> ownHalf = {};   ///< body frame
        std::shared_ptr<const AppearanceZones> zones = {};  ///< of `ownHalf`
    };
    std::optional<Beyond> beyond = {};
};

/// A soft tissue around the jaws: a backdrop, left out where a front face of it would stand between the eye and the
/// crown.
struct ShownTissue {
    std::shared_ptr<const Surface> surface;  ///< tooth frame
    std::vector<Appearance> appearances;
    std::shared_ptr<const AppearanceZones> zones;  ///< as in SceneObject, of the base of `surface`
};

/// Another session to compare with: it is drawn blue, and everything shows through it.
struct ShownOther {
    std::shared_ptr<const Surface> tooth;
    std::optional<ShownTool> tool;
};

/// Everything in a picture of the session, in the tooth's frame. Empty members are not drawn.
struct SceneContents {
    std::shared_ptr<const Surface> tooth;               ///< tags: MaterialId
    MaterialTable materials;                            ///< for the tooth's colours
    std::shared_ptr<const AppearanceZones> zones = {};  ///< of the tooth, from toothZones; null: one look a material
    std::optional<ShownTool> tool;
    std::optional<ShownMirror> mirror;
    std::optional<ShownSuction> suction;
    std::vector<Particle> flying;  ///< water and chips (particlesOf)
    SurfaceLiquids liquids = {};   ///< on the tooth; the water also on what stands around it
    std::vector<ShownBody> around;
    std::vector<ShownTissue> softTissues = {};
    std::optional<ShownOther> other = {};
    Camera camera;
    bool glass = false;  ///< handles and the shank turn to glass where they hide the bur's head and its landing point
};

/// The appearance of each material, by MaterialId.
[[nodiscard]] std::vector<Appearance> appearancesOf(const MaterialTable& materials);

/// The direction to a lamp 15 degrees above the eye and to its left. It lights what the eye sees, but leaves some
/// shadow that shows depth.
[[nodiscard]] Vec3 toLoupeLamp(const Camera& camera);

/// The point of `tooth` that the tip of `tool` meets when it goes on; the tip itself if it meets nothing near. Tooth
/// frame.
[[nodiscard]] Vec3 landingPoint(const Surface& tooth, const ShownTool& tool);

/// The scene under the operating light. Inside a mouth, where the opposite jaw blocks that light, the lamp on the loupe
/// lights it. World frame = tooth frame.
[[nodiscard]] Scene makeScene(const SceneContents& contents);

}  // namespace tactooth

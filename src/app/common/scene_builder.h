// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "instruments/bur_catalogue.h"
#include "instruments/mirror.h"
#include "tooth/model/material.h"
#include "view/scene/scene.h"

namespace tactooth {

/// The instrument that cuts, as it is drawn. Meshes in the tool frame (tip at the origin, +z along the shaft).
struct ShownTool {
    std::shared_ptr<const TriangleMesh> bur;
    std::shared_ptr<const TriangleMesh> turbine;  ///< null: the bur alone
    BurMaterial material = BurMaterial::Carbide;
    Pose toolInTooth;
    double spin = 0;  ///< of the bur about its axis, rad
    double speedRpm = 0;
    BurEdge edge = {};
    std::shared_ptr<const TriangleMesh> blurred =
        {};  ///< the bur as the eye sees it turning fast (spinEnvelopeMesh), or null
};

/// The mirror, as it is drawn.
struct ShownMirror {
    std::shared_ptr<const TriangleMesh> mesh;  ///< mirror frame
    MirrorDisc disc;
    Pose mirrorInTooth;
    float fog = 0, drops = 0;  ///< on the glass, as SceneMirror
};

/// The suction tube, as it is drawn.
struct ShownSuction {
    std::shared_ptr<const TriangleMesh> mesh;  ///< as makeSuctionTube
    Pose tubeInTooth;
};

/// A body that stands around the tooth: a neighbour, the gum.
struct ShownBody {
    std::shared_ptr<const TriangleMesh> mesh;
    Pose bodyInTooth;
    Appearance appearance;
    bool opposite = false;  ///< of the other jaw: left out where it would stand between the eye and the tooth
};

/// All that a picture of the bench shows, in the tooth's frame. Whatever is empty is not there.
struct SceneContents {
    std::shared_ptr<const Surface> tooth;  ///< tagged by MaterialId
    MaterialTable materials;               ///< for the tooth's colours
    std::optional<ShownTool> tool;
    std::optional<ShownMirror> mirror;
    std::optional<ShownSuction> suction;
    std::vector<Particle> flying;  ///< water and chips (particlesOf)
    std::vector<ShownBody> around;
    Camera camera;
};

/// One look for each MaterialId, in their order: colour and roughness from the table.
[[nodiscard]] std::vector<Appearance> appearancesOf(const MaterialTable& materials);

/// Towards a lamp 15 degrees above the eye and to its left: it lights what the eye sees, and leaves it a little shadow
/// to show its depth.
[[nodiscard]] Vec3 toLoupeLamp(const Camera& camera);

/// The picture under the operating light; inside a mouth, where the other jaw stands in that light, by the lamp on the
/// loupe. World frame = tooth frame.
[[nodiscard]] Scene makeScene(const SceneContents& contents);

/// How a tool is held upright: its handle (+x of the tool frame) leaves the mouth mesially, turned `towardLingual` rad
/// to the side of the tongue. `mesialX`: direction of mesial along x.
[[nodiscard]] Quat uprightGrip(double mesialX, double towardLingual);

/// Where a mirror stands that shows the lingual side of a tooth's crown to an eye in the direction `toEye` (unit):
/// behind the crown and level with it, a little to distal, where its handle leaves. `tooth` is the tooth's box,
/// `mesialX` the direction of mesial along x.
[[nodiscard]] Pose parkedMirror(const Box3& tooth, const MirrorDisc& disc, const Vec3& toEye, double mesialX);

/// Where an assistant holds the suction tube: its opening beside the crown, distal and on the cheek's side, so that it
/// is in the way of neither bur nor mirror.
[[nodiscard]] Pose parkedSuction(const Box3& tooth, double mesialX);

}  // namespace tactooth

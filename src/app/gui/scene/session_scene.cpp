// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/session_scene.h"

#include "app/common/mouth_scene.h"
#include "app/common/spray_particles.h"
#include "app/common/tooth_zones.h"
#include "session/hands/mirror_view.h"

namespace tactooth {
namespace {

constexpr float kFog = 0.6F, kDrops = 0.5F;  // share of the glass, 0..1: the crown can still be seen in it

ShownMirror shownMirror(const SessionModel& model, const InstrumentMeshes& meshes) {
    const MirrorState& state = model.instruments().mirror();
    const MirrorGlass& glass = model.instruments().glass();
    return {.mesh = meshes.mirror,
            .disc = meshes.disc,
            .mirrorInTooth = mirrorPose(model),
            .fog = state.fogged ? kFog : kFog * static_cast<float>(glass.fog()),
            .drops = state.wet ? kDrops : 0,
            .dirt = static_cast<float>(glass.dirt())};
}

SurfaceLiquids shownLiquids(const WorkLiquids& liquids) {
    return {.spot = liquids.spot(),
            .water = liquids.water(),
            .slurry = liquids.slurry(),
            .opening = liquids.opening(),
            .blood = liquids.blood()};
}

}  // namespace

SceneContents sceneContents(const SessionModel& model, bool withTurbine, bool withMirror) {
    SceneContents contents;
    contents.materials = model.haptics().materials;
    if (model.runner() == nullptr) return contents;
    const SessionTooth& tooth = *model.tooth();
    const SessionBur& bur = *model.bur();
    const Tick& newest = model.log().newest();
    const std::optional<InstrumentMeshes>& meshes = model.instruments().meshes();
    contents.tooth = model.runner()->feed().surface();
    contents.zones = toothZones(tooth.piece->tooth(), contents.materials);
    contents.around = shownAround(tooth.around);
    contents.softTissues = shownSoftTissues(tooth.softTissues);
    contents.tool = ShownTool{.bur = bur.shown,
                              .turbine = withTurbine && meshes && !bur.isHandInstrument()
                                             ? meshes->handpieces.of(model.haptics().spindle)
                                             : nullptr,
                              .material = bur.material,
                              .toolInTooth = newest.contact.proxy,
                              .spin = model.animation().spin(),
                              .speedRpm = newest.spindle.speedRpm,
                              .edge = bur.instrument.edge,
                              .blurred = bur.blurred,
                              .head = bur.head,
                              .cap = bur.headCap};
    contents.flying = particlesOf(model.animation().particles(), contents.materials);
    contents.liquids = shownLiquids(model.animation().liquids());
    if (!meshes) return contents;
    if (model.instruments().suction()) {
        contents.suction = ShownSuction{meshes->suction, parkedSuction(tooth.box(), tooth.mesialX)};
    }
    if (withMirror) contents.mirror = shownMirror(model, *meshes);
    return contents;
}

Pose mirrorPose(const SessionModel& model) {
    const Pose& held = model.mirror().pose();
    const Pose& moved = model.runner()->feed().mirrorMotion();
    return {held.position + moved.position, (moved.rotation * held.rotation).normalized()};
}

std::optional<MirrorDisc> mirrorGlass(const SessionModel& model) {
    if (model.runner() == nullptr || !model.instruments().meshes()) return std::nullopt;
    return glassAt(model.instruments().meshes()->disc, mirrorPose(model));
}

OrbitCamera::Direction defaultView(const SessionModel& model) {
    const ViewDirection view = model.tooth() ? chairViewOf(*model.tooth()).view : dentistView(model.mesialX());
    return {view.azimuth, view.elevation};
}

}  // namespace tactooth

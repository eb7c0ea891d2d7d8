// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/instrument_set.h"

#include "instruments/contra_angle.h"
#include "instruments/handpiece_kind.h"
#include "instruments/low_speed_handpiece.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"

namespace tactooth {
namespace {

/// Made once in a program, like the handpieces: they are the same for every session.
const std::shared_ptr<const TriangleMesh>& suctionTube() {
    static const auto kTube = std::make_shared<const TriangleMesh>(makeSuctionTube());
    return kTube;
}

}  // namespace

HandpieceMeshes HandpieceMeshes::make() {
    static const HandpieceMeshes kMeshes = {.turbine = std::make_shared<const TriangleMesh>(makeTurbine()),
                                            .contraAngle = std::make_shared<const TriangleMesh>(makeContraAngle()),
                                            .lowSpeed = std::make_shared<const TriangleMesh>(makeLowSpeedHandpiece())};
    return kMeshes;
}

const std::shared_ptr<const TriangleMesh>& HandpieceMeshes::of(const SpindlePreset& spindle) const {
    switch (handpieceOf(spindle)) {
        case HandpieceKind::Turbine:
            return turbine;
        case HandpieceKind::ContraAngle:
            return contraAngle;
        case HandpieceKind::LowSpeed:
            return lowSpeed;
    }
    return turbine;
}

InstrumentSet::InstrumentSet(const TaskExecutor& executor) : task_(executor) {
    task_.start([] {
        InstrumentMeshes meshes;
        meshes.handpieces = HandpieceMeshes::make();
        meshes.suction = suctionTube();
        return Expected<InstrumentMeshes>(std::move(meshes));
    });
}

void InstrumentSet::poll() {
    auto made = task_.poll();
    if (!made) return;
    meshes_ = std::move(**made);
    updateMirror();
}

/// Takes a millisecond.
void InstrumentSet::updateMirror() {
    DentalMirror mirror = makeMirror(mirror_.diameter);
    meshes_->mirror = std::make_shared<const TriangleMesh>(std::move(mirror.surface));
    meshes_->disc = mirror.disc;
}

void InstrumentSet::setMirror(const MirrorState& mirror) {
    const bool isOtherSize = mirror.diameter != mirror_.diameter;
    if (mirror.fogged != mirror_.fogged || mirror.dims != mirror_.dims) glass_.wipe();
    mirror_ = mirror;
    if (isOtherSize && meshes_) updateMirror();
}

void InstrumentSet::muteIdle(DrillSoundState& heard) const {
    if (!water_) heard.water = 0;
    if (!suction_) heard.suction = 0;
}

}  // namespace tactooth

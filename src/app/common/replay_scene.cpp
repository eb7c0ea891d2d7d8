// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/replay_scene.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "instruments/mirror.h"
#include "session/model/spin_envelope_mesh.h"

namespace tactooth {

ReplayBur ReplayBur::of(const Instrument& instrument) {
    if (instrument.hand) {
        const HandInstrumentSpec& spec = specOf(*instrument.hand);
        return {.shown = std::make_shared<const TriangleMesh>(heldInstrument(*instrument.hand)),
                .blurred = nullptr,  // it does not turn
                .edge = {},
                .head = {spec.headLength, spec.headRadius, spec.headRadius},
                .isHandInstrument = true};
    }
    const BurHead head = burHeadOf(instrument.shape->mesh());
    return {std::make_shared<const TriangleMesh>(instrument.shape->mesh()),
            std::make_shared<const TriangleMesh>(spinEnvelopeMesh(instrument.cutting.envelope)), instrument.edge, head,
            std::make_shared<const TriangleMesh>(headCap(head))};
}

ShownTool ReplayBur::at(const Tick& tick, double time, std::shared_ptr<const TriangleMesh> turbine) const {
    constexpr double kTurn = 2 * std::numbers::pi;
    return {.bur = shown,
            .turbine = isHandInstrument ? nullptr : std::move(turbine),
            .material = edge.gritMicrometres > 0 ? BurMaterial::Diamond : BurMaterial::Carbide,
            .toolInTooth = tick.contact.proxy,
            .spin = std::remainder(time * tick.spindle.speedRpm / 60 * kTurn, kTurn),
            .speedRpm = tick.spindle.speedRpm,
            .edge = edge,
            .blurred = blurred,
            .head = head,
            .cap = cap};
}

/// A mirror is made anew when its size changes, which takes a millisecond.
std::optional<ShownMirror> ReplayMirror::at(const MirrorSight& held) {
    if (!held.isShown) return std::nullopt;
    if (made_.mesh == nullptr || held.radius != radius_) {
        const double diameter = mirrorHeadOf(held.radiusMm());
        if (diameter < kSmallestMirror || diameter > kLargestMirror) return std::nullopt;
        DentalMirror mirror = makeMirror(diameter);
        made_ = {.mesh = std::make_shared<const TriangleMesh>(std::move(mirror.surface)),
                 .disc = mirror.disc,
                 .mirrorInTooth = {}};
        radius_ = held.radius;
    }
    ShownMirror shown = made_;
    shown.mirrorInTooth = held.mirror();
    return shown;
}

/// Each body has one material nearly everywhere; it is drawn in that of its first triangle.
std::vector<ShownBody> bodiesAround(const CutModel& model) {
    const std::vector<Appearance> appearances = appearancesOf(MaterialTable(model.tooth().materials()));
    std::vector<ShownBody> bodies;
    for (const auto& part : model.surroundings()) {
        const std::size_t material = part->tags().empty() ? 0 : part->tags().front();
        bodies.push_back({std::make_shared<const TriangleMesh>(part->mesh()),
                          {},
                          {material < appearances.size() ? appearances[material] : Appearance()}});
    }
    return bodies;
}

}  // namespace tactooth

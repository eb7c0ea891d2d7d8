// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cut_events.h"

#include <algorithm>

#include "haptics/cutting_force.h"

namespace tactooth {
namespace {

constexpr double kReached = 1e-4;   // mm^3; less of a tissue, a cube of 46 um, may be the rounding of its border
constexpr double kTurnsRpm = 3000;  // rev/min; faster, it has run up
constexpr double kPedalDown = 0.1;  // a foot that asks for a turning bur, beyond any pedal's dead band

}  // namespace

std::string_view cutEventName(CutEventKind kind) {
    switch (kind) {
        case CutEventKind::FirstContact:
            return "first contact";
        case CutEventKind::DentinReached:
            return "dentin reached";
        case CutEventKind::PulpExposed:
            return "pulp exposed";
        case CutEventKind::BurStalled:
            return "bur stalled";
    }
    return {};
}

void CutEvents::tellOnce(CutEventKind kind, bool happened, double time, const Tick& tick) {
    if (!happened || std::ranges::any_of(events_, [&](const CutEvent& event) { return event.kind == kind; })) return;
    events_.push_back({kind, time, tick.proxy.position});
}

void CutEvents::watch(double time, const Tick& tick, const MaterialVolumes& removed) {
    if (!std::exchange(started_, true)) before_ = removed;
    const auto gone = [&](MaterialId id) {
        return removed[static_cast<std::size_t>(id)] - before_[static_cast<std::size_t>(id)];
    };
    tellOnce(CutEventKind::FirstContact, tick.contacts > 0 || total(removed) > total(before_), time, tick);
    tellOnce(CutEventKind::DentinReached, gone(MaterialId::Dentin) > kReached, time, tick);
    tellOnce(CutEventKind::PulpExposed, gone(MaterialId::Pulp) > kReached, time, tick);
    turned_ = turned_ || tick.speedRpm > kTurnsRpm;
    if (turned_ && tick.speedRpm < kRubsRpm && tick.pedal > kPedalDown && tick.contacts > 0) {
        events_.push_back({CutEventKind::BurStalled, time, tick.proxy.position});
        turned_ = false;
    }
}

}  // namespace tactooth

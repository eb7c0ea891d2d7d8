// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/cut_events.h"

#include <algorithm>

#include "geometry/util/number_text.h"
#include "haptics/cutting_force.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr double kReached = 1e-4;  // mm^3, a cube of 46 um; less of a tissue may be rounding at its boundary
constexpr double kNothing = 1e-6;  // mm^3, a cube of 10 um: less than any bur removes in a cut
constexpr double kAtMost =
    1.05;  // times the loss of the surroundings, which is computed from surfaces and so not exact
constexpr double kTurnsRpm = 3000;  // rev/min: above it the bur has run up
constexpr double kApart = 0.5;      // s without contact: the next touch is a new one
constexpr double kPedalDown = 0.1;  // pedal position beyond any dead band: the foot wants the bur to turn

}  // namespace

const MessageText& cutEventText(CutEventKind kind) {
    switch (kind) {
        case CutEventKind::FirstContact:
            return msg::kFirstContact;
        case CutEventKind::DentinReached:
            return msg::kDentinReached;
        case CutEventKind::PulpNear:
            return msg::kPulpNear;
        case CutEventKind::PulpExposed:
            return msg::kPulpExposed;
        case CutEventKind::NeighbourTouched:
            return msg::kNeighbourTouched;
        case CutEventKind::GingivaTouched:
            return msg::kGingivaTouched;
        case CutEventKind::AdjacentCut:
            return msg::kAdjacentCut;
        case CutEventKind::BurStalled:
            return msg::kBurStalled;
        case CutEventKind::FragmentReleased:
            return msg::kFragmentReleased;
    }
    return msg::kFirstContact;
}

std::string_view cutEventName(CutEventKind kind) { return cutEventText(kind).english; }

std::string cutEventsCsv(std::span<const CutEvent> events) {
    const bool marks = std::ranges::any_of(events, &CutEvent::isTakenBack);
    std::string text = marks ? "t,event,x,y,z,taken_back\n" : "t,event,x,y,z\n";
    for (const auto& [kind, time, place, isTakenBack] : events) {
        text.append(numberText(time)).append(",").append(cutEventName(kind));
        for (const double mm : place) text.append(",").append(numberText(mm));
        if (marks) text += isTakenBack ? ",yes" : ",no";
        text += '\n';
    }
    return text;
}

std::vector<std::size_t> CutEvents::takeBack(double from, double to) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < events_.size(); ++i) {
        if (events_[i].isTakenBack || events_[i].time < from || events_[i].time >= to) continue;
        events_[i].isTakenBack = true;
        places.push_back(i);
    }
    return places;
}

void CutEvents::bringBack(std::span<const std::size_t> places) {
    for (const std::size_t place : places) events_.at(place).isTakenBack = false;
}

void CutEvents::report(CutEventKind kind, double time, const Tick& tick) {
    events_.push_back({kind, time, tick.contact.proxy.position});
}

void CutEvents::reportOnce(CutEventKind kind, bool happened, double time, const Tick& tick) {
    const auto isKnown = [&](const CutEvent& event) { return event.kind == kind && !event.isTakenBack; };
    if (!happened || std::ranges::any_of(events_, isKnown)) return;
    report(kind, time, tick);
}

/// Bodies around a tooth are other teeth, or gum and bone, which have a role of their own.
void CutEvents::updateSurroundings(double time, const Tick& tick) {
    if (!tick.contact.around) return;
    const bool isGingiva = materials_->hasRole(*tick.contact.around, MaterialRole::Surroundings);
    std::optional<double>& last = isGingiva ? gingivaTouchedAt_ : neighbourAt_;
    if (!last || time > *last + kApart) {
        report(isGingiva ? CutEventKind::GingivaTouched : CutEventKind::NeighbourTouched, time, tick);
    }
    last = time;
}

/// Counts the loss since the last call for the tooth itself, unless its neighbours have lost volume meanwhile.
void CutEvents::count(const ToothLoss& loss) {
    const bool isBeside = loss.beside - last_.beside > kNothing;
    for (std::size_t i = 0; i < own_.size(); ++i) {
        const double more = loss.removed[i] - last_.removed[i];
        if (more < 0 || !isBeside) own_[i] = std::max(0.0, own_[i] + more);
    }
    last_ = loss;
}

void CutEvents::update(double time, const Tick& tick, const ToothLoss& loss) {
    const MaterialVolumes& removed = loss.removed;
    if (!std::exchange(started_, true)) {
        before_ = removed;
        besideBefore_ = loss.beside;
        wasNearPulp_ = loss.nearPulp != 0;
        pieces_ = loss.pieces;
        last_ = loss;
    }
    for (std::size_t i = 0; i < removed.size(); ++i) before_[i] = std::min(before_[i], removed[i]);
    besideBefore_ = std::min(besideBefore_, loss.beside);
    wasNearPulp_ = wasNearPulp_ && loss.nearPulp != 0;
    count(loss);
    // Of the tooth itself. A loss beyond that of all neighbours counts as its own.
    const auto isReached = [&](MaterialRole role) {
        return std::ranges::any_of(materials_->ids(), [&](MaterialId id) {
            const auto i = static_cast<std::size_t>(id);
            const double beyond = removed[i] - before_[i] - kAtMost * (loss.beside - besideBefore_);
            return materials_->hasRole(id, role) && std::max(own_[i], beyond) > kReached;
        });
    };
    reportOnce(CutEventKind::FirstContact, tick.contact.triangles > 0 || total(removed) > total(before_), time, tick);
    reportOnce(CutEventKind::DentinReached, isReached(MaterialRole::Dentin), time, tick);
    reportOnce(CutEventKind::PulpNear, loss.nearPulp != 0 && !wasNearPulp_, time, tick);
    reportOnce(CutEventKind::PulpExposed, isReached(MaterialRole::Pulp), time, tick);
    updateSurroundings(time, tick);
    reportOnce(CutEventKind::AdjacentCut, loss.beside - besideBefore_ > kReached, time, tick);
    if (loss.pieces > pieces_) report(CutEventKind::FragmentReleased, time, tick);
    pieces_ = loss.pieces;
    turned_ = turned_ || tick.spindle.speedRpm > kTurnsRpm;
    // A drive that runs down because cutting was switched off does not stall.
    if (turned_ && tick.input.cutting && tick.spindle.speedRpm < kMinCuttingRpm && tick.input.pedal > kPedalDown &&
        tick.contact.triangles > 0) {
        report(CutEventKind::BurStalled, time, tick);
        turned_ = false;
    }
}

}  // namespace tactooth

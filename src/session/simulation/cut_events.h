// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/util/message.h"
#include "haptics/haptic_simulation.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// The events of a cut that a teacher wants to know.
enum class CutEventKind {
    FirstContact,
    DentinReached,
    PulpNear,
    PulpExposed,
    NeighbourTouched,
    GingivaTouched,
    AdjacentCut,
    BurStalled,
    FragmentReleased
};

inline constexpr std::array kCutEventKinds = {
    CutEventKind::FirstContact, CutEventKind::DentinReached,    CutEventKind::PulpNear,
    CutEventKind::PulpExposed,  CutEventKind::NeighbourTouched, CutEventKind::GingivaTouched,
    CutEventKind::AdjacentCut,  CutEventKind::BurStalled,       CutEventKind::FragmentReleased};

/// "first contact", "dentin reached", "pulp near", "pulp exposed", "neighbour touched", "gum or bone touched", "cut
/// beside the tooth", "bur stalled", "piece came loose".
[[nodiscard]] std::string_view cutEventName(CutEventKind kind);
/// The same in any language.
[[nodiscard]] const MessageText& cutEventText(CutEventKind kind);

struct CutEvent {
    CutEventKind kind;
    double time;               ///< s
    Vec3 place;                ///< the bur's tip in the tooth's frame, mm
    bool isTakenBack = false;  ///< its cut was undone: it is listed, but does not count
};

/// As a table: t,event,x,y,z; with a last column taken_back (yes or no) if any was.
[[nodiscard]] std::string cutEventsCsv(std::span<const CutEvent> events);

/// Detects the events of a cut tick by tick. First contact, each tissue of the tooth itself, a cut near its pulp and a
/// cut beside the tooth are reported once. While a neighbour loses volume as well, a tissue counts when more of it has
/// gone than all neighbours lost. A touch of a neighbour, gum or bone is reported again after half a second without
/// contact. Each stall and each fall of detached pieces is reported.
class CutEvents {
public:
    /// `materials`: of the tooth; they say which material is dentin, pulp or gingiva.
    explicit CutEvents(const MaterialRegistry& materials = builtinMaterials()) : materials_(&materials) {}
    /// Goes on with the events of an earlier session with this tooth.
    CutEvents(const MaterialRegistry& materials, std::vector<CutEvent> before)
        : materials_(&materials), events_(std::move(before)) {}

    /// `loss`: everything up to this tick. The first call sets what was cut before. Volume that undo or reset has put
    /// back and that is cut again gives no new event.
    void update(double time, const Tick& tick, const ToothLoss& loss);

    /// Marks the events from `from` to before `to` (s) as taken back: their cut was undone. Of a kind that is reported
    /// once, another one may come then. Returns the places in `all` of those that were not taken back before.
    std::vector<std::size_t> takeBack(double from, double to);
    /// The opposite, for what `takeBack` has returned: the cut was redone.
    void bringBack(std::span<const std::size_t> places);

    /// All events, by rising time.
    [[nodiscard]] const std::vector<CutEvent>& all() const { return events_; }

private:
    void report(CutEventKind kind, double time, const Tick& tick);
    void reportOnce(CutEventKind kind, bool happened, double time, const Tick& tick);
    void updateSurroundings(double time, const Tick& tick);
    void count(const ToothLoss& loss);

    const MaterialRegistry* materials_;
    std::vector<CutEvent> events_;
    MaterialVolumes before_{};
    double besideBefore_ = 0;
    ToothLoss last_;          // at the last call
    MaterialVolumes own_{};   // of the tooth itself, since the first call, mm^3
    std::size_t pieces_ = 0;  // fallen pieces at the last call
    bool started_ = false;
    bool wasNearPulp_ = false;                              // at the first call, and since
    bool turned_ = false;                                   // whether the bur has turned since it last stalled
    std::optional<double> neighbourAt_, gingivaTouchedAt_;  // time of the last touch, s
};

}  // namespace tactooth

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

/// What a teacher wants to know of a cut.
enum class CutEventKind {
    FirstContact,
    DentinReached,
    PulpExposed,
    NeighbourTouched,
    GingivaTouched,
    AdjacentCut,
    BurStalled,
    FragmentReleased
};

inline constexpr std::array kCutEventKinds = {CutEventKind::FirstContact,   CutEventKind::DentinReached,
                                              CutEventKind::PulpExposed,    CutEventKind::NeighbourTouched,
                                              CutEventKind::GingivaTouched, CutEventKind::AdjacentCut,
                                              CutEventKind::BurStalled,     CutEventKind::FragmentReleased};

/// "first contact", "dentin reached", "pulp exposed", "neighbour touched", "gum or bone touched", "cut beside the
/// tooth", "bur stalled", "piece came loose".
[[nodiscard]] std::string_view cutEventName(CutEventKind kind);
/// The same in any language.
[[nodiscard]] const MessageText& cutEventText(CutEventKind kind);

struct CutEvent {
    CutEventKind kind;
    double time;  ///< s
    Vec3 place;   ///< the bur's tip in the tooth's frame, mm
};

/// As a table: t,event,x,y,z.
[[nodiscard]] std::string cutEventsCsv(std::span<const CutEvent> events);

/// Watches a cut tick by tick. The first contact, each tissue of the tooth itself and a cut into what stands around are
/// told once (a tissue that goes while a neighbour is cut as well: when more of it has gone than the neighbours lost);
/// a neighbour, gum or bone each time that the tool comes to touch it after half a second without; a stalled bur each
/// time that it stalls; pieces that came loose each time that some have fallen.
class CutEvents {
public:
    /// `loss`: everything up to this tick. The first call tells what had been cut before; what is put back (undo,
    /// reset) and cut again is no news.
    void update(double time, const Tick& tick, const ToothLoss& loss);

    /// In the order of their times.
    [[nodiscard]] const std::vector<CutEvent>& all() const { return events_; }

private:
    void report(CutEventKind kind, double time, const Tick& tick);
    void reportOnce(CutEventKind kind, bool happened, double time, const Tick& tick);
    void updateSurroundings(double time, const Tick& tick);
    void count(const ToothLoss& loss);

    std::vector<CutEvent> events_;
    MaterialVolumes before_{};
    double besideBefore_ = 0;
    ToothLoss last_;          // at the last call
    MaterialVolumes own_{};   // of the tooth itself, since the first call, mm^3
    std::size_t pieces_ = 0;  // that had fallen at the last call
    bool started_ = false;
    bool turned_ = false;                                   // the bur did, since it stalled last
    std::optional<double> neighbourAt_, gingivaTouchedAt_;  // when it was touched last, s
};

}  // namespace tactooth

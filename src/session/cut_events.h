// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "haptics/haptic_simulation.h"
#include "tooth/cut_volume.h"

namespace tactooth {

/// What a teacher wants to know of a cut.
enum class CutEventKind { FirstContact, DentinReached, PulpExposed, BurStalled };

/// "first contact", "dentin reached", "pulp exposed", "bur stalled".
[[nodiscard]] std::string_view cutEventName(CutEventKind kind);

struct CutEvent {
    CutEventKind kind;
    double time;  ///< s
    Vec3 place;   ///< the bur's tip in the tooth's frame, mm
};

/// Watches a cut tick by tick. The first contact and each tissue are told once, a stalled bur each time that it stalls.
class CutEvents {
public:
    /// `removed`: everything up to this tick. The first call tells what had been cut before.
    void watch(double time, const Tick& tick, const MaterialVolumes& removed);

    /// In the order of their times.
    [[nodiscard]] const std::vector<CutEvent>& all() const { return events_; }

private:
    void tellOnce(CutEventKind kind, bool happened, double time, const Tick& tick);

    std::vector<CutEvent> events_;
    MaterialVolumes before_{};
    bool started_ = false;
    bool turned_ = false;  // the bur did, since it stalled last
};

}  // namespace tactooth

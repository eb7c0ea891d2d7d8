// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/scene_builder.h"
#include "session/kernel/session_event.h"
#include "session/recording/mirror_sight.h"

// A moment of a recorded session as a picture.

namespace tactooth {

/// A bur of a recording as it is drawn.
struct ReplayBur {
    std::shared_ptr<const TriangleMesh> shown, blurred;
    BurEdge edge;
    BurHead head = {};  ///< of `shown`
    std::shared_ptr<const TriangleMesh> cap = {};
    bool isHandInstrument = false;  ///< without a handpiece

    [[nodiscard]] static ReplayBur of(const Instrument& instrument);
    /// The instrument at a tick; `time`: of the session, s. `turbine`: the handpiece behind the bur, or null.
    [[nodiscard]] ShownTool at(const Tick& tick, double time, std::shared_ptr<const TriangleMesh> turbine) const;
};

/// The mouth mirror of a recording as it is drawn.
class ReplayMirror {
public:
    /// None where it was not held, or has a size that no mirror has. The glass is clean: a recording does not say what
    /// was on it.
    [[nodiscard]] std::optional<ShownMirror> at(const MirrorSight& held);

private:
    ShownMirror made_;         // of the size below; without a mesh until the first one is made
    std::int64_t radius_ = 0;  // of its glass, as in MirrorSight
};

/// The bodies around a recorded tooth, as they are drawn.
[[nodiscard]] std::vector<ShownBody> bodiesAround(const CutModel& model);

}  // namespace tactooth

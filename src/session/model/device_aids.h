// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "session/model/session_bur.h"

namespace tactooth {

/// What helps a hand that feels force: a stop at the depth that the mouse cuts to, too, and a guide at the walls of the
/// ideal cavity. Both are off at first. One thread.
class DeviceAids {
public:
    void setDepthStop(bool on) { stops_ = on; }
    void setGuide(bool on) { guides_ = on; }
    /// Where the walls are (guideWalls); null: there are none.
    void setWalls(std::shared_ptr<const DistanceGrid> walls);
    /// What the hand holds. A hand instrument gets no aid: a probe goes as deep as it can.
    void setBur(const SessionBur& bur);

    /// Gives the aids that are on to a device. `depth`: the floor at which it stops.
    void addTo(SessionControls& controls, const DepthControl& depth) const;

private:
    void makeGuide();

    bool stops_ = false, guides_ = false;
    std::shared_ptr<const DistanceGrid> walls_;
    std::optional<RevolutionEnvelope> bur_;   // none: no bur is held
    std::shared_ptr<const WallGuide> guide_;  // of the walls and the bur; null: one of them is not there
};

}  // namespace tactooth

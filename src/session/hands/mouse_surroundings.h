// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "session/hands/mouse_manipulator.h"
#include "session/simulation/cut_model.h"

namespace tactooth {

/// Keeps the mouse's hand up to date with what it may touch: the tooth as it is cut, and the tool. One thread.
class MouseSurroundings {
public:
    /// Another tooth, or another hand: the next call of `show` counts.
    void forget() { surface_.reset(); }
    /// Gives `hand` the present `surface` of the tooth with all that stands around it, the `tool`, and the surface of
    /// the tooth before any cut, if anything of it has changed.
    void show(MouseManipulator& hand, const CutModel& tooth, const std::shared_ptr<const Surface>& surface,
              const std::shared_ptr<const ToolShape>& tool);

private:
    std::shared_ptr<const Surface> surface_;  // that the hand knows
    std::shared_ptr<const ToolShape> tool_;
    std::shared_ptr<const SurfacePart> uncut_;
};

}  // namespace tactooth

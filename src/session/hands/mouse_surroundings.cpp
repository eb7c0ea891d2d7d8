// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mouse_surroundings.h"

namespace tactooth {

void MouseSurroundings::show(MouseManipulator& hand, const CutModel& tooth,
                             const std::shared_ptr<const Surface>& surface,
                             const std::shared_ptr<const ToolShape>& tool) {
    if (surface == surface_ && tool == tool_) return;
    if (surface_ == nullptr) uncut_ = tooth.tooth().ownOuter();
    surface_ = surface;
    tool_ = tool;
    hand.setSurroundings({surrounded(surface, tooth.surroundings()), tool, uncut_});
}

}  // namespace tactooth

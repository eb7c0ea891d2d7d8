// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/common/scene_builder.h"
#include "session/simulation/tooth_in_mouth.h"

namespace tactooth {

/// The bodies around a tooth in a mouth, ready to draw, in the tooth's frame.
[[nodiscard]] std::vector<ShownBody> shownAround(std::span<const ToothInMouth::Body> around);

/// The soft tissues around a tooth in a mouth, ready to draw, in the tooth's frame.
[[nodiscard]] std::vector<ShownTissue> shownSoftTissues(std::span<const SoftTissueBody> tissues);

enum class ShownJaws { Both, Upper, Lower };

/// A whole mouth, ready to draw, in its own frame.
[[nodiscard]] std::vector<ShownBody> shownMouth(const BuiltinMouth& mouth, ShownJaws jaws = ShownJaws::Both);

/// Its soft tissues, ready to draw, in the same frame.
[[nodiscard]] std::vector<ShownTissue> shownSoftTissues(const BuiltinMouth& mouth);

}  // namespace tactooth

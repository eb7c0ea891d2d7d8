// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/common/scene_builder.h"
#include "session/simulation/tooth_in_mouth.h"

namespace tactooth {

/// What is drawn around a tooth that stands in a mouth, in its frame.
[[nodiscard]] std::vector<ShownBody> shownAround(const ToothInMouth& tooth);

enum class ShownJaws { Both, Upper, Lower };

/// A whole mouth, in its own frame.
[[nodiscard]] std::vector<ShownBody> shownMouth(const BuiltinMouth& mouth, ShownJaws jaws = ShownJaws::Both);

}  // namespace tactooth

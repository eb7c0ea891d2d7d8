// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "assessment/process/work_strip.h"
#include "geometry/util/message.h"

namespace tactooth {

/// A drawing (SVG) of this size, mm. The marks have their numbers, from 1.
[[nodiscard]] std::string stripSvg(const WorkStrip& strip, double width, double height,
                                   Language language = Language::English);

}  // namespace tactooth

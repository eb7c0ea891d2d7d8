// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/preparation.h"
#include "geometry/util/message.h"

namespace tactooth {

/// Where `place` lies in a preparation, seen along its axis: "mesiobuccal", "distal", "in the middle".
[[nodiscard]] const MessageText& placeName(const Vec3& place, const Vec3& middle, const DentalDirections& directions);

}  // namespace tactooth

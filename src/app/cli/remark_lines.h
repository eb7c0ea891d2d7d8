// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/remark.h"

namespace tactooth {

/// Says on stderr what was mended in the files that a command reads, a line each.
void printRemarks(const std::vector<Remark>& remarks);

}  // namespace tactooth

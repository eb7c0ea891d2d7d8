// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/material_volumes.h"

#include <numeric>

namespace tactooth {

double total(const MaterialVolumes& volumes) { return std::accumulate(volumes.begin(), volumes.end(), 0.0); }

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/binned_sah.h"

namespace tactooth {

/// Sorts items along a Hilbert curve through their centres: items that are near on the curve are near in space. Leaves
/// of successive items make a tree in a third of the time of the binned SAH. The sort is stable. Good for a few
/// thousand items at most: the curve has 512 cells.
void sortByHilbertIndex(const TreeRange& range);

}  // namespace tactooth

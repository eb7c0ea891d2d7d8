// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/binned_sah.h"

namespace tactooth {

/// Sorts items along a curve that fills the space around their centres, so that those near on it are near in space:
/// packets of them make a tree in a third of the time that the search for the cheapest split takes. Of equal places the
/// order stays. Good for a few thousand at most: the curve has 512 places.
void sortByHilbertIndex(const TreeRange& range);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "view/camera/camera.h"
#include "view/gl/rgba.h"

namespace tactooth {

/// Rows of a picture from `first` up to, but not including, `end`.
struct ChangedRows {
    int first = 0;
    int end = 0;
};

/// Smooths the stair steps of edges in `picture`, the rows of a picture of this size in either order (morphological
/// antialiasing). A pixel at an edge is mixed with its neighbour beyond the edge. All other pixels stay as they are,
/// and so do the outermost ones. Returns rows beyond which nothing has changed.
ChangedRows smoothEdges(std::span<Rgba> picture, ImageSize size);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "collision/pair_list.h"

namespace tactooth {

/// A surface on its way to the hand, with the list of what is near the tool in it.
struct FeltSurface {
    std::shared_ptr<const Surface> surface;
    PairList near;
    Vec3 reach = Vec3::Zero();  ///< where the cut lets the tool's tip go to, mm
};

/// Finds what is near a tool in a new surface before the hand feels it: in the cavity that it has just cut a bur has
/// thousands of triangles near, and a look for all of them takes far longer than a tick has. The cutter's thread makes;
/// the servo takes a FeltSurface, leaves its old surface and list in it, and the cutter gets it back.
class FeltSurfaces {
public:
    /// `tool` outlives this object.
    explicit FeltSurfaces(const ToolShape& tool) : tool_(&tool) {}

    /// For a tool that stands at `from` and will go on about as far as `to`. Owned by this object.
    [[nodiscard]] FeltSurface* make(std::shared_ptr<const Surface> surface, const Pose& from, const Pose& to);
    /// Takes back what `make` has given, with whatever is in it now.
    void giveBack(FeltSurface* felt);

private:
    const ToolShape* tool_;
    std::vector<std::unique_ptr<FeltSurface>> all_;
    std::vector<FeltSurface*> free_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "collision/neighbours/neighbour_list.h"
#include "collision/proxy/contact_query.h"

namespace tactooth {

/// A surface for the servo thread, with the neighbour list of the tool in it.
struct HapticSurface {
    std::shared_ptr<const Surface> surface;
    NeighbourList near;              ///< of the tool in that surface
    Vec3 reach = Vec3::Zero();       ///< farthest position of the tool's tip that the cut allows, tooth's frame, mm
    std::optional<Pose> place = {};  ///< a free pose of the tool, for a proxy that has no pose yet
};

/// Builds the neighbour list of a new surface before the servo thread uses it. In a cavity that it has just cut, a bur
/// has thousands of triangles near it, and a search for all of them takes far longer than a tick. The neighbour-list
/// thread builds. The servo thread takes a HapticSurface and leaves its old surface and list in it; the neighbour-list
/// thread gets it back with `recycle`.
class HapticSurfaceBuilder {
public:
    /// `surface` is the one that the tool is in now. Neither pointer is null.
    HapticSurfaceBuilder(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface);

    /// Pose of the tool at a time in s. From one call to the next, the builder measures how fast the tool moves and
    /// rotates, and how long a list has to last. `ownListRebuilds` counts how often the servo thread has had to rebuild
    /// its own list so far. After such a rebuild the last list is of no use any more.
    void watch(double time, const Pose& toolInTooth, std::uint32_t ownListRebuilds = 0);

    /// Builds the list of a surface for a tool at `from` that moves on toward `to`, or with its measured velocity,
    /// until the next list. Finds the separating planes on the path toward `to` in advance, too. This object owns the
    /// result.
    [[nodiscard]] HapticSurface* make(std::shared_ptr<const Surface> surface, const Pose& from, const Pose& to);
    /// Builds a new list of the last surface around the last watched pose. Null while the tool stays well within the
    /// margin of the last list.
    [[nodiscard]] HapticSurface* rebuild();
    /// For a device that is inside the tooth: the surface with the free pose nearest to the device, which takes
    /// milliseconds to find. Null if the device is free, and if no free pose is found.
    [[nodiscard]] HapticSurface* place(std::shared_ptr<const Surface> surface, const Pose& deviceInTooth);
    /// Takes back what `make`, `rebuild` or `place` has returned, with whatever it holds now.
    void recycle(HapticSurface* hapticSurface);

private:
    [[nodiscard]] HapticSurface* list(const Pose& at, const ContactMargin& contactMargin);
    [[nodiscard]] double ahead() const;
    [[nodiscard]] Vec3 drift() const;

    std::shared_ptr<const ToolShape> tool_;
    std::optional<ContactQuery> query_;  // made when the first tool needs a pose
    std::vector<std::unique_ptr<HapticSurface>> all_;
    std::vector<HapticSurface*> free_;

    // The measured motion of the tool.
    double time_ = -1;  // s; negative: no call yet
    Pose pose_;
    double pause_ = 0;              // low-passed time between two calls of watch, s
    Vec3 velocity_ = Vec3::Zero();  // low-passed, mm/s
    double spin_ = 0;               // low-passed chord of the rotation a second, as in ContactMargin
    std::uint32_t ownListRebuilds_ = 0;
    bool isListStale_ = false;  // the servo thread cannot use the last list any more

    std::shared_ptr<const Surface> surface_;
    // The last list.
    Pose listedAt_;
    ContactMargin listed_{Vec3::Zero(), 0, 0};
    double longest_ = std::numeric_limits<double>::infinity();  // largest length of the next list's margin, mm
};

}  // namespace tactooth

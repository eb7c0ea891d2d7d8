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

/// A surface on its way to the hand, with the list of what is near the tool in it.
struct HapticSurface {
    std::shared_ptr<const Surface> surface;
    NeighbourList near;
    Vec3 reach = Vec3::Zero();       ///< where the cut lets the tool's tip go to, mm
    std::optional<Pose> place = {};  ///< a free one, for a tool that has none of its own
};

/// Finds what is near a tool in a new surface before the hand feels it: in the cavity that it has just cut a bur has
/// thousands of triangles near, and a look for all of them takes far longer than a tick has. A thread of its own makes;
/// the servo takes a HapticSurface, leaves its old surface and list in it, and the maker gets it back.
class HapticSurfaceBuilder {
public:
    /// `surface`: the one that the tool is in as yet.
    HapticSurfaceBuilder(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface)
        : tool_(std::move(tool)), surface_(std::move(surface)) {}

    /// Where the tool is, at a time in s. From one call to the next it is seen how fast the tool moves and turns, and
    /// how long a list has to last.
    /// `ownListRebuilds`: how often it has had to look itself for what is near, so far. Whenever it had to, the last
    /// list is of no use to it any more.
    void watch(double time, const Pose& toolInTooth, std::uint32_t ownListRebuilds = 0);

    /// For a tool that stands at `from` and will go on toward `to`, or the way it was watched to go, until the next
    /// list. What parts it from the surface on the way toward `to` is looked up ahead, too. Owned by this object.
    [[nodiscard]] HapticSurface* make(std::shared_ptr<const Surface> surface, const Pose& from, const Pose& to);
    /// The surface made last (or the first one) with a new list, around the pose watched last. Null as long as the tool
    /// stays well within what the last list covers.
    [[nodiscard]] HapticSurface* rebuild();
    /// For a hand that came into the tooth: the surface with the free pose next to the hand, which takes milliseconds
    /// to find. Null where the hand is free, and where no way out is found.
    [[nodiscard]] HapticSurface* place(std::shared_ptr<const Surface> surface, const Pose& deviceInTooth);
    /// Takes back what `make` has given, with whatever is in it now.
    void recycle(HapticSurface* hapticSurface);

private:
    [[nodiscard]] HapticSurface* list(const Pose& at, const ContactMargin& contactMargin);
    [[nodiscard]] double ahead() const;
    [[nodiscard]] Vec3 drift() const;

    std::shared_ptr<const ToolShape> tool_;
    std::optional<ContactQuery> query_;  // made when a tool has to be placed
    std::vector<std::unique_ptr<HapticSurface>> all_;
    std::vector<HapticSurface*> free_;

    // The tool, as watched.
    double time_ = -1;  // s; negative: not yet
    Pose pose_;
    double pause_ = 0;              // between two looks of late, s
    Vec3 velocity_ = Vec3::Zero();  // of late, mm/s
    double spin_ = 0;               // of late: chord a second, as in Skin
    std::uint32_t ownListRebuilds_ = 0;
    bool isListStale_ = false;  // the tool has no use for the last list any more

    std::shared_ptr<const Surface> surface_;
    // The last list.
    Pose listedAt_;
    ContactMargin listed_{Vec3::Zero(), 0, 0};
    double longest_ = std::numeric_limits<double>::infinity();  // that the next one is worth, mm
};

}  // namespace tactooth

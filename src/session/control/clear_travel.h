// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision/bvh/surface.h"
#include "collision/proxy/contact_query.h"

namespace tactooth {

/// Moves a tool through free space. The whole tool keeps clear of everything that it could touch, at the goal and on
/// the path: where the straight path is blocked it rises along its shaft, goes across, and comes down again. Poses are
/// those of the tool in the tooth's frame. One thread.
class ClearTravel {
public:
    static constexpr double kClearance = 0.25;  ///< mm between the tool and what it must not touch, about
    static constexpr double kSpeed = 160;       ///< mm/s: the tool is where the mouse points before the eye has settled

    /// What travels, and among what. Null: nothing is known, and the tool goes straight.
    void setTool(const std::shared_ptr<const ToolShape>& tool);
    void setSurface(const std::shared_ptr<const Surface>& touchable);

    /// Whether the tool is clear of everything at a pose.
    [[nodiscard]] bool isClear(const Pose& pose);
    /// The clear pose nearest to `pose` that the tool reaches by rising along its shaft from there; none up to kRise.
    [[nodiscard]] std::optional<Pose> risen(const Pose& pose);
    static constexpr double kRise = 24;  ///< mm: above the longest crown

    /// Where the device stands: the pose that it was sent to, and the tool behind it, which follows smoothly.
    struct Place {
        Pose sent;
        Pose tool;
        bool isHeld = false;  ///< something holds the tool away from the device
    };
    /// Goes to `goal`, or above it if the tool would not be clear there. A tool that is not clear yet first leaves
    /// along its shaft. Keeps its path if the goal has not moved.
    void goTo(const Place& from, const Pose& goal);
    /// Where to send the device for the next `dt` s. At a corner that the tool may not cut it waits for the tool.
    /// Without a path it stays.
    [[nodiscard]] Pose advance(const Place& from, double dt);
    [[nodiscard]] bool hasArrived() const { return path_.empty(); }
    void stop();

private:
    [[nodiscard]] bool isPathClear(const Pose& from, const Pose& to);
    [[nodiscard]] std::vector<Pose> pathTo(const Pose& from, const Pose& goal);
    [[nodiscard]] bool mayTurn(const Place& from, const Pose& corner);

    std::shared_ptr<const ToolShape> tool_;      // as it was given
    std::shared_ptr<const ToolShape> inflated_;  // by kClearance
    std::shared_ptr<const Surface> surface_;
    std::optional<ContactQuery> query_;  // of the inflated tool
    std::vector<Pose> path_;             // from the last place to the first
    std::optional<Pose> goal_;           // of the path
};

}  // namespace tactooth

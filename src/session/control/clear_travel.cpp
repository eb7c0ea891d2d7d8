// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/clear_travel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tooth/volume/bur_feed.h"

namespace tactooth {
namespace {

constexpr double kSample = 0.8 * ClearTravel::kClearance;  // mm between two poses that are checked on a path
constexpr double kRiseStep = 0.25;                         // mm
constexpr double kSamePlace = 1e-6;                        // mm, and rad
constexpr double kTurnLength = 10;                         // mm for each rad: a turn takes as long as its far end

/// The tool, thicker by `by` mm all around: each corner goes outward along the sum of the normals of its triangles,
/// weighed by their area.
TriangleMesh inflated(const TriangleMesh& tool, double by) {
    std::vector<Vec3> normals(tool.vertices.size(), Vec3::Zero());
    for (const Triangle& triangle : tool.triangles) {
        const Vec3 a = tool.vertices[triangle[0]].cast<double>();
        const Vec3 normal =
            (tool.vertices[triangle[1]].cast<double>() - a).cross(Vec3(tool.vertices[triangle[2]].cast<double>() - a));
        for (const std::uint32_t corner : triangle) normals[corner] += normal;
    }
    TriangleMesh result = tool;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double length = normals[i].norm();
        if (length > 0) result.vertices[i] += (by / length * normals[i]).cast<float>();
    }
    return result;
}

Vec3 alongShaft(const Pose& pose) { return pose.rotation * Vec3::UnitZ(); }

bool isSame(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() < kSamePlace && a.rotation.angularDistance(b.rotation) < kSamePlace;
}

Pose shifted(const Pose& pose, const Vec3& by) { return {pose.position + by, pose.rotation}; }

}  // namespace

void ClearTravel::setTool(const std::shared_ptr<const ToolShape>& tool) {
    if (tool == tool_) return;
    tool_ = tool;
    inflated_ = tool ? std::make_shared<const ToolShape>(inflated(tool->mesh(), kClearance)) : nullptr;
    query_.reset();
    goal_.reset();
}

void ClearTravel::setSurface(const std::shared_ptr<const Surface>& touchable) {
    if (touchable == surface_) return;
    surface_ = touchable;
    goal_.reset();  // the path may be blocked now
    if (query_ && surface_ != nullptr) {
        (void)query_->setSurface(surface_);
    } else {
        query_.reset();
    }
}

bool ClearTravel::isClear(const Pose& pose) {
    if (inflated_ == nullptr || surface_ == nullptr) return true;
    if (!query_) query_.emplace(inflated_, surface_);
    return query_->isFree(pose);
}

std::optional<Pose> ClearTravel::risen(const Pose& pose) {
    for (double rise = 0; rise <= kRise; rise += kRiseStep) {
        const Pose raised = shifted(pose, rise * alongShaft(pose));
        if (isClear(raised)) return raised;
    }
    return std::nullopt;
}

/// The poses on the path are so close to each other that the clearance covers what is between them.
bool ClearTravel::isPathClear(const Pose& from, const Pose& to) {
    if (inflated_ == nullptr) return true;
    const double length = (to.position - from.position).norm() + from.rotation.angularDistance(to.rotation) *
                                                                     (inflated_->centre().norm() + inflated_->radius());
    const int steps = std::max(1, static_cast<int>(std::ceil(length / kSample)));
    for (int i = 1; i <= steps; ++i) {
        if (!isClear(between(from, to, static_cast<double>(i) / steps))) return false;
    }
    return true;
}

/// The poses of the path from the last to the first; empty if there is no path.
std::vector<Pose> ClearTravel::pathTo(const Pose& from, const Pose& goal) {
    if (isPathClear(from, goal)) return {goal};
    constexpr std::array kHeights = {1.0, 2.0, 4.0, 7.0, 11.0, 16.0, kRise};  // mm
    for (const double height : kHeights) {
        const Pose above = shifted(from, height * alongShaft(from));
        const Pose aboveGoal = shifted(goal, height * alongShaft(goal));
        if (isPathClear(from, above) && isPathClear(above, aboveGoal) && isPathClear(aboveGoal, goal)) {
            return {goal, aboveGoal, above};
        }
    }
    return {};
}

void ClearTravel::goTo(const Place& from, const Pose& goal) {
    if (goal_ && isSame(*goal_, goal)) return;
    goal_ = goal;
    path_.clear();
    const std::optional<Pose> clear = risen(goal);
    const std::optional<Pose> start = from.isHeld ? risen(from.tool) : risen(from.sent);
    if (!clear || !start) return;
    path_ = pathTo(*start, *clear);
    if (path_.empty()) return;
    if (isSame(*start, from.sent) && isPathClear(from.tool, path_.back())) return;
    if (!isSame(*start, from.sent)) path_.push_back(*start);
    path_.push_back(from.isHeld ? from.tool : from.sent);
}

/// Whether the tool has reached a corner of its path, or may cut it. It follows the device smoothly: it stays within
/// the triangle between its place, the corner and the next place.
bool ClearTravel::mayTurn(const Place& from, const Pose& corner) {
    constexpr double kReached = 0.1;  // mm
    if (!from.isHeld && (from.tool.position - corner.position).norm() < kReached) return true;
    return !from.isHeld && isClear(from.tool) && isPathClear(from.tool, path_[path_.size() - 2]);
}

Pose ClearTravel::advance(const Place& from, double dt) {
    Pose at = from.sent;
    double left = kSpeed * dt;
    while (!path_.empty()) {
        const Pose& next = path_.back();
        const double length =
            std::max((next.position - at.position).norm(), kTurnLength * at.rotation.angularDistance(next.rotation));
        if (length > left) return between(at, next, left / length);
        at = next;
        left -= length;
        if (path_.size() > 1 && !mayTurn(from, next)) return at;
        path_.pop_back();
    }
    return at;
}

void ClearTravel::stop() {
    path_.clear();
    goal_.reset();
}

}  // namespace tactooth

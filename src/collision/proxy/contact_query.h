// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision/proxy/proxy_solver.h"

namespace tactooth {

/// The contact of a tool with a tooth at one pose.
struct Contact {
    bool touching = false;
    double depth = 0;            ///< mm; the tool is just free when moved by this along `normal`
    Vec3 normal = Vec3::Zero();  ///< unit, direction of the shortest exit that was found; zero when not touching
    Vec3 point = Vec3::Zero();   ///< the tool's deepest point, in the tooth's frame, mm
    int contacts = 0;            ///< pairs of triangles that intersect
    std::uint32_t part = 0;      ///< of the contact that holds the tool (see ProxyContact)
    std::uint32_t tooth = 0;     ///< triangle of that part
};

/// Contact of a tool with a tooth at single poses, without history. For an open surface only the triangles count: it
/// has no inside.
///
/// Keeps buffers between queries; one thread at a time.
class ContactQuery {
public:
    ContactQuery(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface);

    /// Replaces the surface. Returns the one before, so that the caller decides where it is freed.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface);

    /// Depth at one pose.
    [[nodiscard]] Contact at(const Pose& toolInTooth);

    /// The published penalty method: the deepest pair of intersecting triangles, on its own. For comparison only: on a
    /// fine mesh it is neither deep enough nor in the right direction to free the tool (`normal` and `depth` free only
    /// that pair).
    [[nodiscard]] Contact deepestPairAt(const Pose& toolInTooth);

    /// Whether no part of the tool is in the tooth. Allocates nothing as long as at most a few thousand pairs are near.
    [[nodiscard]] bool isFree(const Pose& toolInTooth);

    /// The free pose that `at` found for the last touching pose.
    [[nodiscard]] const Pose& freePose() const { return freePose_; }

private:
    struct Overlap {
        std::vector<NearPair> pairs;
        bool enclosed = false;  // the tool is wholly inside, touching no triangle
        [[nodiscard]] bool any() const { return enclosed || !pairs.empty(); }
    };

    template <class Take>
    void forEachIntersecting(const Pose& toolInTooth, Take&& take);
    [[nodiscard]] bool isEnclosed(const Pose& toolInTooth) const;
    void findOverlap(const Pose& toolInTooth);
    [[nodiscard]] std::vector<Vec3> exitDirections(const Pose& toolInTooth, const Overlap& overlap) const;
    [[nodiscard]] std::optional<double> exitDistance(const Pose& toolInTooth, const Vec3& direction, double limit);
    void tryExitDirections(const Pose& toolInTooth, Contact& best);
    [[nodiscard]] bool leaves(const Pose& toolInTooth, const Vec3& direction, double distance);
    [[nodiscard]] double leastAlong(const Pose& toolInTooth, const Vec3& direction, double clear);
    [[nodiscard]] bool tryExit(const Pose& toolInTooth, const Vec3& out, Contact& best);
    void refineDirection(const Pose& toolInTooth, Contact& best);
    void searchAround(const Pose& toolInTooth, Contact& best);
    void searchBeside(const Pose& toolInTooth, Contact& best);
    void keepShallowerExit(const Pose& toolInTooth, const Pose& start, Contact& best);

    std::shared_ptr<const ToolShape> tool_;
    std::shared_ptr<const Surface> surface_;
    ProxySolver proxy_;
    NeighbourList list_;
    Overlap overlap_;
    RecentPairs blocking_;  // pairs that intersected at recent poses: they are tested first
    Pose freePose_;
    Vec3 normalSum_ = Vec3::Zero();  // of the contacts at the free pose
};

}  // namespace tactooth

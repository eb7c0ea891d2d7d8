// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "collision/nearest_in_polyhedron.h"
#include "collision/pair_list.h"
#include "collision/separating_planes.h"
#include "collision/tool_shape.h"
#include "geometry/pose.h"

namespace tactooth {

/// How a move ended.
enum class MoveStatus {
    Reached,      ///< the body stands at the goal
    Held,         ///< contacts hold it as near to the goal as they allow
    OutOfRounds,  ///< the fixed budget ran out on the way; the pose is free and the next move goes on from it
    Overlapping,  ///< the pose to start from was not free (a surface was changed under it)
};

/// A pair of triangles that holds the body.
struct BodyContact {
    Vec3 normal;          ///< unit, from the tooth to the tool
    Vec3 point;           ///< on the tool, in the tooth's frame, mm
    double share;         ///< of the push along `normal`, mm: pose - goal = sum of share * normal
    std::uint32_t part;   ///< 0 = base of the surface, i + 1 = patch i
    std::uint32_t tooth;  ///< triangle of that part
};

struct MoveResult {
    MoveStatus status = MoveStatus::Reached;
    int rounds = 0;     ///< linearisations
    int distances = 0;  ///< GJK runs
    int contactCount = 0;
    std::array<BodyContact, 3> contacts{};
};

/// A rigid tool that moves among the triangles of a tooth and never enters them. Each move goes toward a goal pose;
/// what stands in the way is slid along, so the body ends where the distance to the goal is locally least. This is
/// the "god object" of haptics with the tool's own STL for a shape. The orientation follows the goal as far as the
/// tooth lets it.
///
/// Fixed memory: moving allocates nothing. One thread at a time.
class SlidingBody {
public:
    explicit SlidingBody(std::shared_ptr<const ToolShape> tool);

    /// Puts the body among the triangles of `surface`. Returns the surface that it stood in before, so that the caller
    /// decides where that is freed.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface);

    /// Puts the body at a pose that is free of contact (the caller knows; see isFree in contact_query.h).
    void placeAt(const Pose& toolInTooth);

    /// Forgets what earlier moves have found out: after placeAt, the moves to come do not depend on them to the last
    /// bit.
    void forget();

    /// Moves toward `goal`, sweeping the way: nothing is passed through, whatever the length of the move.
    MoveResult moveToward(const Pose& goal);

    [[nodiscard]] const Pose& pose() const { return pose_; }
    [[nodiscard]] const ToolShape& tool() const { return *tool_; }
    [[nodiscard]] const Surface* surface() const { return surface_.get(); }
    /// The distance that the body keeps from the tooth, mm: far below what any device or eye resolves, far above the
    /// rounding of doubles.
    [[nodiscard]] double margin() const { return margin_; }

private:
    struct Attempt;
    struct SweptTool;
    enum class Offence { None, Found, Overlapping };

    [[nodiscard]] bool plan(const Pose& goal, bool isFirst, double trust, Attempt& attempt);
    [[nodiscard]] Vec3 expectedWay(const Pose& goal);
    [[nodiscard]] bool runsShort(const Vec3& way, double turn) const;
    void renewList(const Vec3& way, double turn);
    [[nodiscard]] bool isListed(const Vec3& position) const;
    [[nodiscard]] double shareWithinSkin(const Vec3& step) const;
    [[nodiscard]] bool findSafeStep(Attempt& attempt, bool& overlapping);
    [[nodiscard]] bool solve(Attempt& attempt);
    [[nodiscard]] WatchedPair watch(const NearPair& pair, const Vec3& guess) const;
    [[nodiscard]] bool hasPlane(WatchedPair& watched);
    [[nodiscard]] bool refreshPlane(WatchedPair& watched);
    void preferFace(const Triangle3& tooth, const Triangle3& tool, SeparatingPlane& plane) const;
    [[nodiscard]] double gapAt(const WatchedPair& watched, const Mat3& rotation, const Vec3& position) const;
    void sweep(std::uint32_t triangle, const Attempt& attempt, SweptTool& swept) const;
    [[nodiscard]] bool provenSafe(const NearPair& pair, const Attempt& attempt, SweptTool& swept,
                                  const SeparatingPlane** own);
    [[nodiscard]] Offence offends(const NearPair& pair, const Vec3& guess, const Attempt& attempt,
                                  WatchedPair& watched);
    [[nodiscard]] Offence recentViolation(const Attempt& attempt, WatchedPair& offender);
    [[nodiscard]] Offence violation(const Attempt& attempt, WatchedPair& offender);
    [[nodiscard]] Offence violationIn(std::size_t cluster, const Excursion& excursion, const Attempt& attempt,
                                      SweptTool& swept, WatchedPair& offender);
    [[nodiscard]] bool findWayOn(const Pose& goal);
    [[nodiscard]] bool takeOtherPlane(int contact, std::span<HalfSpace> planes, const Vec3& toGoal);
    void addConstraint(Attempt& attempt, const WatchedPair& watched) const;
    void restart(Attempt& attempt);
    void accept(const Attempt& attempt, MoveResult& result);

    std::shared_ptr<const ToolShape> tool_;
    std::shared_ptr<const Surface> surface_;
    Pose pose_;
    std::uint64_t poseStamp_ = 2;
    double margin_ = 0;

    PairList list_;
    Pose lastGoal_;
    bool isBehind_ = false;  // the last move ran out of rounds
    double handWay_ = 0;     // to go in this move: of the goal since the last move, mm
    double handTurn_ = 0;    // a chord, as in Skin
    double growth_ = 1;      // of the next list over the first of a move

    SeparatingPlanes planes_;
    RecentPairs recent_;
    std::array<WatchedPair, 3> held_{};  // pairs active at the end of the last round
    int heldCount_ = 0;
    int distances_ = 0;
};

}  // namespace tactooth

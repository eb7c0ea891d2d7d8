// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "collision/narrow/contact_features.h"
#include "collision/neighbours/neighbour_list.h"
#include "collision/neighbours/separating_planes.h"
#include "collision/neighbours/tool_shape.h"
#include "collision/proxy/qp3.h"
#include "collision/proxy/qp6.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// How a move ended.
enum class MoveStatus {
    Reached,          ///< the body stands at the goal
    InContact,        ///< contacts hold it as near to the goal as they allow
    OutOfIterations,  ///< the rounds ran out on the way; the pose is free and the next move goes on from it
    OutOfBudget,      ///< the budget did, see setBudget; likewise
    Overlapping,      ///< the pose to start from was not free (a surface was changed under it)
};

/// In what a tool may differ from the hand's pose while contacts hold it.
enum class Freedom {
    Translation,             ///< in its place alone (3 degrees): it turns as the hand does, as far as the tooth lets it
    TranslationAndRotation,  ///< in its place and its orientation (6 degrees): for devices that render torque
};

/// The most contacts that can hold a body at once: as many as it has degrees of freedom.
inline constexpr int kMaxHeld = 6;

/// A pair of triangles that holds the body.
struct BodyContact {
    Vec3 normal;          ///< unit, from the tooth to the tool
    Vec3 point;           ///< on the tool, in the tooth's frame, mm
    double share;         ///< of the push along `normal`, mm: shift = sum of share * normal, where the shift is that
                          ///< of the tool's centre from goal to pose
    std::uint32_t part;   ///< 0 = base of the surface, i + 1 = patch i
    std::uint32_t tooth;  ///< triangle of that part
};

struct MoveResult {
    MoveStatus status = MoveStatus::Reached;
    int iterations = 0;  ///< linearisations
    int distances = 0;   ///< GJK runs
    Work work = 0;       ///< that it took
    int contactCount = 0;
    std::array<BodyContact, kMaxHeld> contacts{};
};

/// A rigid tool that moves among the triangles of a tooth and never enters them. Each move goes toward a goal pose;
/// what stands in the way is slid along, so the body ends where the distance to the goal is locally least. This is
/// the "god object" of haptics with the tool's own STL for a shape.
///
/// With six degrees of freedom the distance is that of Gauss' principle of least constraint: the square of the shift of
/// the tool's centre, and that of the turn (as a rotation vector) times `characteristicLength`; so with turn = from
/// goal to pose, characteristicLength^2 * turn = sum over the contacts of share * lever x normal, the lever from the
/// centre to the contact.
///
/// Fixed memory: moving allocates nothing. One thread at a time.
class ProxySolver {
public:
    explicit ProxySolver(std::shared_ptr<const ToolShape> tool, Freedom freedom = Freedom::Translation);

    /// Puts the body among the triangles of `surface`. Returns the surface that it stood in before, so that the caller
    /// decides where that is freed.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface);
    /// The same with a list made ahead of need (by another thread), of this surface and this tool: the next move need
    /// not look for what is near, as long as it stays where the list was made for. `near` holds the old list after it.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface, NeighbourList& near);

    /// Puts the body at a pose that is free of contact (the caller knows; see isFree in contact_query.h).
    void placeAt(const Pose& toolInTooth);

    /// Puts the body at a pose that is free of contact, not far away: what is known of its surroundings still holds.
    void shiftTo(const Pose& toolInTooth);
    /// Whether the body would stand clear of all triangles at a pose (it may still be wholly inside). Nothing where the
    /// pose is beyond what the body knows.
    [[nodiscard]] std::optional<bool> isClearAt(const Pose& toolInTooth);

    /// Forgets what earlier moves have found out: after placeAt, the moves to come do not depend on them to the last
    /// bit.
    void forget();

    /// No move shall do much more than this, beside one look for what is near: for a loop that must keep its time. A
    /// move that has done so much stops where it is; the next one goes on from there with twice the budget, and those
    /// after it with four times: what is dear once is spread, what stays dear is paid. Without limit at first.
    void setBudget(Work budget);

    /// Moves toward `goal`, sweeping the displacement: nothing is passed through, whatever the length of the move. A
    /// body that has settled stays where it is, bit for bit and without work, until goal or surface change.
    MoveResult moveToward(const Pose& goal);

    /// How often the body has had to look itself for what is near.
    [[nodiscard]] std::uint32_t ownListRebuilds() const { return ownListRebuilds_; }

    [[nodiscard]] const Pose& pose() const { return pose_; }
    [[nodiscard]] const ToolShape& tool() const { return *tool_; }
    [[nodiscard]] const Surface* surface() const { return surface_.get(); }
    /// The distance that the body keeps from the tooth, mm: far below what any device or eye resolves, far above the
    /// rounding of doubles.
    [[nodiscard]] double margin() const { return margin_; }
    /// What a turn counts against a shift: the radius of gyration of a rod as long as the tool, mm.
    [[nodiscard]] double characteristicLength() const;

private:
    struct Attempt;
    struct SweptTool;
    struct SweepQuery;
    struct ContactPlane;
    struct FeatureContact;
    enum class Violation { None, Found, Overlapping, OutOfBudget };

    void enter(std::shared_ptr<const Surface>& surface);
    [[nodiscard]] bool plan(const Pose& goal, bool isFirst, double trust, Attempt& attempt);
    [[nodiscard]] Vec3 predictedShift(const Pose& goal);
    [[nodiscard]] Vec3 predictedShift(Attempt& attempt, double& turn);
    [[nodiscard]] int maxLists() const;
    [[nodiscard]] bool isWithinList() const;
    [[nodiscard]] bool mayWaitForNextList() const;
    [[nodiscard]] bool isListFresh() const;
    [[nodiscard]] bool isListExhausted(const Vec3& displacement, double turn) const;
    void rebuildList(const Vec3& displacement, double turn);
    [[nodiscard]] bool isListed(const Vec3& position) const;
    [[nodiscard]] double shareWithinMargin(const Vec3& step) const;
    [[nodiscard]] bool isStationary(const Attempt& attempt) const;
    [[nodiscard]] bool findSafeStep(Attempt& attempt, bool& overlapping);
    [[nodiscard]] bool solve(Attempt& attempt);
    [[nodiscard]] bool solveRotating(Attempt& attempt) const;
    [[nodiscard]] Qp6Result nearestRotating(const Attempt& attempt) const;
    void moveTo(const Vec3& shift, const Vec3& turn, Attempt& attempt) const;
    [[nodiscard]] double shareAllowed(const Vec3& shift, const Vec3& turn, Attempt& attempt) const;
    [[nodiscard]] WatchedPair watch(const NearPair& pair, const Vec3& guess) const;
    [[nodiscard]] bool hasPlane(WatchedPair& watched);
    [[nodiscard]] bool refreshPlane(WatchedPair& watched);
    void preferFace(const Triangle3& tooth, const Triangle3& tool, SeparatingPlane& plane) const;
    [[nodiscard]] double gapAt(const WatchedPair& watched, const Mat3& rotation, const Vec3& position) const;
    [[nodiscard]] SweptTool& sweep(std::uint32_t triangle, const Attempt& attempt, SweepQuery& look) const;
    [[nodiscard]] bool isSeparatedByActive(double toothTop, const SweptTool& swept, int normal) const;
    [[nodiscard]] bool provenSafe(const NearPair& pair, const Attempt& attempt, SweepQuery& look,
                                  const SeparatingPlane** own);
    [[nodiscard]] bool separatedByRotatingPlane(const Triangle3& tooth, const SweptTool& swept);
    [[nodiscard]] Violation checkPair(const NearPair& pair, const Vec3& guess, const Attempt& attempt,
                                      WatchedPair& watched);
    [[nodiscard]] Violation recentViolation(const Attempt& attempt, SweepQuery& look, WatchedPair& violator);
    [[nodiscard]] Violation violation(const Attempt& attempt, SweepQuery& look, WatchedPair& violator);
    [[nodiscard]] Violation violationIn(std::size_t cluster, const ToolMotion& motion, const Attempt& attempt,
                                        SweepQuery& look, WatchedPair& violator);
    void measureLeaf(std::size_t cluster, SweepQuery& look) const;
    [[nodiscard]] bool isSeparatedByActive(std::size_t cluster, const Attempt& attempt, SweepQuery& look) const;
    [[nodiscard]] bool switchContactPlanes(const Pose& goal, Attempt& attempt);
    void storeWarmStart(Attempt& attempt) const;
    [[nodiscard]] bool allowsProgress(std::span<const HalfSpace> spaces, const Vec3& toGoal) const;
    [[nodiscard]] ContactPlane contactPlaneOf(WatchedPair& watched) const;
    [[nodiscard]] bool switchPlane(std::size_t contact, std::span<ContactPlane> holds, std::span<HalfSpace> spaces,
                                   const Vec3& toGoal);
    [[nodiscard]] bool switchPlanesTogether(std::size_t contact, std::span<ContactPlane> holds,
                                            std::span<const HalfSpace> spaces, const Vec3& toGoal);
    void take(const ContactPlane& hold, const Vec3& normal);
    void addConstraint(Attempt& attempt, const WatchedPair& watched) const;
    void addRotatingConstraint(Attempt& attempt, const WatchedPair& watched) const;
    void addFeatureConstraint(Attempt& attempt, const WatchedPair& watched, const FeaturePair& features) const;
    [[nodiscard]] FeaturePair featuresToConstrain(const Attempt& attempt, const WatchedPair& watched) const;
    [[nodiscard]] std::optional<FeaturePair> blockingFeatures(const Attempt& attempt, const WatchedPair& watched) const;
    [[nodiscard]] bool stillTouch(const WatchedPair& watched, const FeaturePair& features) const;
    [[nodiscard]] static int placeOf(const Attempt& attempt, const WatchedPair& watched, const FeaturePair& features);
    [[nodiscard]] FeaturePair lowestCorner(const Attempt& attempt, const WatchedPair& watched) const;
    [[nodiscard]] FeatureGap gapOf(const WatchedPair& watched, const FeaturePair& features,
                                   const Pose& toolInTooth) const;
    void restart(Attempt& attempt);
    [[nodiscard]] Vec3 deepestPoint(const WatchedPair& held) const;
    void accept(const Attempt& attempt, MoveResult& result);
    [[nodiscard]] bool isUnchanged() const;
    void remember(const MoveResult& result);
    [[nodiscard]] bool isOutOfBudget() const { return work_ - firstList_ > allowed_; }
    void settleBudget(bool hasStepped, MoveResult& result);

    std::shared_ptr<const ToolShape> tool_;
    Freedom freedom_;
    std::shared_ptr<const Surface> surface_;
    Pose pose_;
    std::uint64_t poseStamp_ = 2;
    double margin_ = 0;

    NeighbourList list_;
    bool isListExternal_ = false;
    bool hasListProvider_ = false;  // whether somebody makes lists ahead
    int listWaits_ = 0;             // moves that have ended at the end of that list, one after the other
    int listRests_ = 0;             // moves to stay where it is, for want of a list
    std::uint32_t ownListRebuilds_ = 0;
    Pose lastGoal_;
    bool isLagging_ = false;      // the last move ran out of rounds
    bool isBudgetSpent_ = false;  // the last move ran out of work before its first step
    double stepScale_ = 1;        // share of the usual first step: a starved body takes small ones
    double goalShift_ = 0;        // to go in this move: of the goal since the last move, mm
    double goalRotation_ = 0;     // a chord, as in Skin
    int lists_ = 0;               // made in this move

    SeparatingPlanes planes_;
    RecentPairs recent_;
    std::array<WatchedPair, kMaxHeld> held_{};  // pairs active at the end of the last round
    std::array<FeaturePair, kMaxHeld> heldFeatures_{};
    int heldCount_ = 0;
    // Of the last move: what held the body at its end, for how many moves it has been the same, and what a move to the
    // same goal would find.
    std::array<NearPair, kMaxHeld> lastHeld_{};
    int lastHeldCount_ = 0;
    int unchangedMoves_ = 0;
    bool isSettled_ = false;
    MoveResult settled_;
    std::uint32_t lastViolation_ = 0;  // the eight clusters in which the last look found a pair in the way
    int distances_ = 0;
    Work work_ = 0;
    Work firstList_ = 0;  // of it: a move that must look for what is near shall not stand still for that
    Work budget_ = kUnlimitedWork;
    Work allowed_ = kUnlimitedWork;  // in this move
};

}  // namespace tactooth

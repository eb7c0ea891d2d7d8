// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Private to ProxySolver: what its source files share.

#include "collision/narrow/contact_features.h"
#include "collision/proxy/proxy_solver.h"

namespace tactooth {

inline constexpr int kMaxPlanesPerIteration =
    32;  // 3-6 are usual; more means that the step is long for its surroundings

inline constexpr int kMaxWarmStart = 8;  // pairs that are kept in mind from the round before
inline constexpr int kMaxContactPlanes = kMaxHeld + kMaxWarmStart;

inline constexpr double kSolved = 1e-3;  // of the margin: how exactly a round's planes are solved for

// A body that has run out of work before its first step tries a shorter one, which brings less in doubt. At the
// shortest it does the work whatever it costs: so it never stands still for long.
inline constexpr double kMinStepScale = 1.0 / 64;

inline constexpr double kSamePlane = 1 - 1e-12;  // cosine: 1.4 microradians apart

inline constexpr Work kMaxAllowance = 2;  // budgets of a move that goes on where the one before ran out of its own

/// What keeps a tool that may turn from a triangle.
struct ProxySolver::FeatureContact {
    FeaturePair features;
    int tries = 0;  // how often they have been made linear in this round
    Vec3 normal = Vec3::Zero();
    Vec3 point = Vec3::Zero();
};

/// One round in the making.
struct ProxySolver::Attempt {
    Pose goal;
    double rotationFraction = 1;  // of the turn still to make
    bool rotatesFully = true;
    double allowance = 0;  // how far the tool may be shifted, mm
    Quat rotation;         // at the end of the round
    Mat3 matrix;
    Mat3 startMatrix;
    Vec3 step = Vec3::Zero();
    bool clipped = false;          // the step was shortened to the allowance
    bool rotationClipped = false;  // the turn was shortened since the list ends there
    bool clippedToList = false;    // the turn or the step was
    int planeCount = 0;
    std::array<WatchedPair, kMaxPlanesPerIteration> watched;
    std::array<HalfSpace, kMaxPlanesPerIteration> halfSpaces;    // of the steps
    std::array<HalfSpace6, kMaxPlanesPerIteration> halfSpaces6;  // of the shifts and turns, in their place
    std::array<FeatureContact, kMaxPlanesPerIteration> touches;  // what they keep apart
    // Pairs that stood in the way of a round before, from the pose at hand.
    int warmStartCount = 0;
    std::array<WatchedPair, kMaxWarmStart> warmStart;
    Vec3 shift = Vec3::Zero();  // of the tool's centre
    Vec3 turn = Vec3::Zero();   // rotation vector
    double rotationLeft = 0;    // that the list covers, a chord
    double rotationBound = 0;   // no turn is longer, rad
    // The planes that the step runs into.
    int activeCount = 0;
    std::array<int, kMaxHeld> active;
    std::array<double, kMaxHeld> multiplier;

    [[nodiscard]] const Vec3& activeNormal(int i) const { return watched[active[i]].plane.normal; }
    template <class Answer>
    void setActive(const Answer& answer) {
        activeCount = answer.activeCount;
        std::copy_n(answer.active.begin(), activeCount, active.begin());
        std::copy_n(answer.multiplier.begin(), activeCount, multiplier.begin());
    }

    void rotateBy(const Quat& from, double fraction) {
        rotationFraction = fraction;
        rotation = fraction <= 0   ? from
                   : fraction >= 1 ? goal.rotation
                                   : from.slerp(fraction, goal.rotation).normalized();
        matrix = rotation.toRotationMatrix();
        startMatrix = from.toRotationMatrix();
    }
};

/// Normals of planes that part pairs: of those that hold the tool, and of a few that a look has met.
inline constexpr int kMaxNormals = kMaxHeld + 2;

/// A triangle of the tool at the start (three corners) and the end of an attempted step, and how far it reaches along
/// the normals of a look, as many of them as were measured.
struct ProxySolver::SweptTool {
    std::uint32_t triangle = kNone;
    int measured = 0;
    std::array<Vec3, 6> corners;
    std::array<double, kMaxNormals> startLow, endLow;

    static constexpr std::uint32_t kNone = ~0U;

    [[nodiscard]] double lowAtStart(const Vec3& normal) const {
        return lowestAlong(std::span<const Vec3>(corners).first(3), normal);
    }
    [[nodiscard]] double lowAtEnd(const Vec3& normal) const {
        return lowestAlong(std::span<const Vec3>(corners).last(3), normal);
    }
};

/// One look over the list for what an attempted step would bring together. Around a contact dozens of pairs share the
/// corner that touches: along the plane that holds the tool they are a margin apart, far less than single precision can
/// tell. So it is remembered how far the tool's triangles and the leaves of the tooth reach toward those planes. Where
/// faces lie on each other (the end of a bur on the floor that it has milled) the plane that holds the tool may lean by
/// a trifle, and thousands of pairs are parted by the face's own instead: a plane that parts a pair so narrowly is
/// looked at for those to come.
struct ProxySolver::SweepQuery {
    struct Leaf {
        std::uint32_t number = SweptTool::kNone;
        int measured = 0;
        std::array<double, kMaxNormals> top;  // of its triangles along each normal
    };
    static constexpr std::size_t kPlaces = 32;  // direct-mapped: what pushes another out costs time alone
    std::array<Vec3, kMaxNormals> normals;
    int count = 0;
    Vec3 lastMet = Vec3::Zero();
    std::array<SweptTool, kPlaces> tools;
    std::array<Leaf, kPlaces> leaves;

    explicit SweepQuery(const Attempt& attempt) : count(attempt.activeCount) {
        for (int i = 0; i < count; ++i) normals[i] = attempt.activeNormal(i);
    }

    /// A plane has parted a pair narrowly. One that parts two in a row is worth a try for all.
    void met(const Vec3& normal) {
        if (count < kMaxNormals && normal.dot(lastMet) > kSamePlane) normals[count++] = normal;
        lastMet = normal;
    }
    [[nodiscard]] SweptTool& tool(std::uint32_t triangle) { return tools[triangle % kPlaces]; }
    [[nodiscard]] Leaf& leaf(std::uint32_t number) { return leaves[number % kPlaces]; }
};

}  // namespace tactooth

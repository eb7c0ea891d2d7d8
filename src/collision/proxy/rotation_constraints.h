// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/candidate_step.h"
#include "collision/proxy/constraint_set.h"
#include "collision/proxy/proxy_context.h"

namespace tactooth {

/// The constraints of a step in position and orientation (6 degrees of freedom), and the step nearest to the goal that
/// they allow. Same interface as TranslationConstraints.
///
/// The unknowns are the shift of the tool's centre (mm) and the rotation vector times the characteristic length (mm).
class RotationConstraints {
public:
    static constexpr bool kRotates = true;
    using Set = ConstraintSet<6>;

    [[nodiscard]] const Set& set() const { return set_; }

    /// The displacement of the tool's origin expected in this move, mm, as far as the contacts of the last move allow.
    /// `turn` becomes the chord of the rotation expected.
    [[nodiscard]] Vec3 predictShift(ProxyContext& context, CandidateStep& step, double& turn);
    /// Starts an iteration with the contacts of the one before: usually they are still active.
    void restart(ProxyContext& context, CandidateStep& step);
    /// Finds the step nearest to the goal under the constraints so far, shortened to its limits. False if there is
    /// none.
    [[nodiscard]] bool solve(const ProxyContext& context, CandidateStep& step);
    /// Adds a constraint that keeps apart a pair which the step would bring together. If none of its features blocks
    /// the step, the rotation may be too large for a separating plane: then a rotation is tried so small that the paths
    /// of the corners differ from straight lines by less than the margin.
    void add(const ProxyContext& context, CandidateStep& step, const WatchedPair& watched);
    /// Whether the step is known to stay where it is: never with rotation.
    [[nodiscard]] static bool isStationary(const ProxyContext&, const CandidateStep&) { return false; }
    /// Stores the active pairs in the context, and writes them as contacts.
    void storeContacts(ProxyContext& context, MoveResult& result) const;
    void clearWarmStart() {}

private:
    /// The features of a pair that a constraint keeps apart.
    struct FeatureContact {
        FeaturePair features;
        int tries = 0;  // linearisations in this iteration
        Vec3 normal = Vec3::Zero();
        Vec3 point = Vec3::Zero();
    };

    void moveTo(const ProxyScene& scene, const Vec3& shift, const Vec3& turn, CandidateStep& step);
    void addFeatures(const ProxyScene& scene, const CandidateStep& step, const WatchedPair& watched,
                     const FeaturePair& features);
    [[nodiscard]] FeaturePair featuresToConstrain(const ProxyScene& scene, const CandidateStep& step,
                                                  const WatchedPair& watched) const;
    [[nodiscard]] int find(const WatchedPair& watched, const FeaturePair& features) const;
    [[nodiscard]] Qp6Result nearest(const ProxyScene& scene, const Pose& goal) const;
    [[nodiscard]] double shareAllowed(const ProxyContext& context, const Vec3& shift, const Vec3& turn,
                                      CandidateStep& step);

    Set set_;
    std::array<FeatureContact, Set::kCapacity> features_;  // of each constraint
    Vec3 shift_ = Vec3::Zero();                            // of the tool's centre in the step, mm
    Vec3 turn_ = Vec3::Zero();                             // rotation vector of the step
};

}  // namespace tactooth

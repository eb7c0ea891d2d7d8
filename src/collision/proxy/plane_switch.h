// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "collision/proxy/contact_directions.h"
#include "collision/proxy/proxy_context.h"
#include "collision/proxy/qp3.h"
#include "collision/proxy/translation_constraints.h"

namespace tactooth {

/// Looks for separating planes that let a settled tool move on.
///
/// Where two triangles touch at an edge or a corner, many planes separate them. The present plane may forbid a motion
/// that another one allows. The switch tries the other planes of each contact, and takes the first that allows a motion
/// toward the goal.
class PlaneSwitch {
public:
    PlaneSwitch(ProxyContext& context, const Pose& goal)
        : context_(context), toGoal_(goal.position - context.scene.pose.position) {}

    /// Adds a contact of the tool. All contacts come before the other pairs. The pair must outlive the switch.
    void addContact(WatchedPair& watched) {
        TACTOOTH_ASSERT(contacts_ == count_);
        addPair(watched);
        contacts_ = count_;
    }
    /// Adds another pair that blocks the tool here. The pair must outlive the switch.
    void addPair(WatchedPair& watched);
    /// Tries the planes of each contact in turn. True if a plane was replaced, in the pair that was added.
    [[nodiscard]] bool run();

private:
    static constexpr std::size_t kCapacity = kMaxHeld + TranslationConstraints::kMaxWarmStart;

    /// A pair with its triangles at the present pose.
    struct Candidate {
        WatchedPair* watched = nullptr;
        Triangle3 tooth, tool;
        double gap = 0;    // width of the slab along the present plane, mm
        double least = 0;  // width that another plane must leave, mm

        [[nodiscard]] HalfSpace spaceOf(const Vec3& normal, double back, double margin) const;
        /// The steps that the plane with this normal allows, if it separates the pair.
        [[nodiscard]] std::optional<HalfSpace> separatingSpace(const Vec3& normal, double margin) const;
    };

    [[nodiscard]] bool allowsProgress(std::span<const HalfSpace> spaces) const;
    [[nodiscard]] bool switchPlane(std::size_t contact);
    [[nodiscard]] bool switchTogether(std::size_t contact);
    void take(const Candidate& candidate, const Vec3& normal);

    ProxyContext& context_;
    Vec3 toGoal_;  // mm
    std::size_t count_ = 0;
    std::size_t contacts_ = 0;
    std::array<Candidate, kCapacity> candidates_;
    std::array<HalfSpace, kCapacity> spaces_;
};

}  // namespace tactooth

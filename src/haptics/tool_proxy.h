// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>

#include "collision/proxy/contact_query.h"
#include "collision/proxy/proxy_solver.h"
#include "haptics/contact_force.h"
#include "haptics/haptic_surface.h"

namespace tactooth {

enum class ContactMode {
    Proxy,    ///< the tool's pose that never penetrates follows the hand; depth is the distance between the two
    Penalty,  ///< the published way: depth of the deepest pair of triangles at the hand's own pose, no history
};

/// What the hand meets at one tick.
struct ProxyState {
    Pose proxy;  ///< of the tool in the tooth; in penalty mode the hand's pose moved out by the depth
    /// Where the hand would hold the tip if it had turned with the proxy, mm: with three degrees of freedom, where it
    /// holds it.
    Vec3 deviceTip = Vec3::Zero();
    Vec3 offset = Vec3::Zero();  ///< from there to the proxy's tip, mm
    double travel = 0;           ///< of the proxy since the last tick, mm
    double late = 0;             ///< what it has left of its way since its work ran out, mm
    bool placed = false;         ///< false: no free pose is known, and no force may be made from this
    int contacts = 0;            ///< triangles that hold the proxy (penalty: pairs that intersect)
    int contactPointCount = 0;
    std::array<ContactPoint, kMaxHeld> held{};

    [[nodiscard]] std::span<const ContactPoint> contactPoints() const {
        return {held.data(), static_cast<std::size_t>(contactPointCount)};
    }
};

/// Follows the hand with a tool that never enters the tooth, from the first tick on: also when the hand starts inside,
/// and when cutting changes the surface under the tool.
class ToolProxy {
public:
    static constexpr double kTick = 0.001;  ///< s, of a caller that does not say

    ToolProxy(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface, ContactMode mode,
              Freedom freedom = Freedom::Translation);

    /// `goal`: how far the tool shall go in this tick where that is not all the way to the hand; `dt`: since the last
    /// tick, s.
    ProxyState follow(const Pose& deviceInTooth, const Pose& goal, double dt = kTick);
    ProxyState follow(const Pose& deviceInTooth) { return follow(deviceInTooth, deviceInTooth); }

    [[nodiscard]] const Pose& pose() const { return body_.pose(); }
    /// See ProxySolver.
    [[nodiscard]] std::uint32_t ownListRebuilds() const { return body_.ownListRebuilds(); }
    void setBudget(Work budget) { body_.setBudget(budget); }

    [[nodiscard]] const std::shared_ptr<const ToolShape>& tool() const { return tool_; }
    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return surface_; }

    /// Takes the newest surface. Returns the old one, so that the caller frees it away from the servo thread.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface);
    /// The same with what HapticSurfaceBuilder has found near the tool. The surface and list before the present ones
    /// stay in `felt`; the present ones are kept in case that the new surface has caught the tool. A tool without a
    /// place takes that of `felt`. False: it is no new surface, and only its list is taken.
    bool setSurface(HapticSurface& felt);

    /// From now on a tool whose hand came into the tooth waits for a HapticSurface that tells it its place: to find
    /// that takes longer than a tick has. Until then no tick is placed.
    void deferPlacement() { placesItself_ = false; }

    /// Forgets the history: the next tick places the tool anew.
    void release() { placed_ = false; }

private:
    [[nodiscard]] ProxyState followByPenalty(const Pose& deviceInTooth);
    [[nodiscard]] bool takeSurface(HapticSurface& felt);
    void placeNear(const Pose& deviceInTooth);
    [[nodiscard]] bool isFree(const Pose& toolInTooth);
    [[nodiscard]] bool retractFromSurface(double farthest);
    void swapSurfaces();
    [[nodiscard]] bool revertSurface();
    void retryNewestSurface(double dt);
    [[nodiscard]] MoveResult moveToward(const Pose& goal);
    [[nodiscard]] Vec3 deviceTip(const Pose& deviceInTooth) const;
    [[nodiscard]] bool isEnclosed(const Pose& toolInTooth) const;
    void holdWithoutContact(ProxyState& state);
    void fillContactPoint(ContactPoint& held, std::uint32_t part, std::uint32_t triangle) const;

    std::shared_ptr<const ToolShape> tool_;
    std::shared_ptr<const Surface> surface_;
    ContactMode mode_;
    Freedom freedom_;
    ProxySolver body_;
    ContactQuery query_;
    bool placesItself_ = true;
    bool placed_ = false;
    bool newSurface_ = false;         // since the last tick
    HapticSurface other_;             // the surface that was felt before this one, or the newest where that waits
    bool isAtOldPose_ = false;        // the tool still stands where it stood in the one before
    std::optional<double> waitTime_;  // s that the newest has waited for the tool to be free in it; none: it is felt
    int failedTries_ = 0;             // to feel a new surface, since one was felt last
    Vec3 farEnd_ = Vec3::Zero();      // of the tool, away from the tip
    bool touching_ = false;           // at the last tick
    ContactPoint lastContact_;        // by what was touched last
    Vec3 exitDirection_ = Vec3::UnitZ();  // direction of the last contact
};

}  // namespace tactooth

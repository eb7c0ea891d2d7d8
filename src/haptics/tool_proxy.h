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

/// How the contact is computed.
enum class ContactMode {
    Proxy,    ///< the proxy follows the device and never penetrates; the depth is the distance between the two
    Penalty,  ///< penalty method, for comparison: the depth of the deepest triangle pair at the device pose, without
              ///< history
};

/// The state of the proxy at one tick.
struct ProxyState {
    Pose proxy;  ///< pose of the tool in the tooth; in penalty mode the device pose moved out by the depth
    /// Position of the device's tip, mm, if the device were rotated about the tool's centre to the orientation of the
    /// proxy. With three degrees of freedom it is the device's tip itself.
    Vec3 deviceTip = Vec3::Zero();
    Vec3 offset = Vec3::Zero();  ///< from there to the proxy's tip, mm
    double travel = 0;           ///< displacement of the proxy since the last tick, mm
    double late = 0;             ///< distance to the goal that is left because the work budget ran out, mm
    bool placed = false;         ///< false: no free pose is known, and there must be no force
    int contacts = 0;            ///< triangles that hold the proxy (penalty: pairs that intersect)
    int contactPointCount = 0;
    std::array<ContactPoint, kMaxHeld> held{};

    [[nodiscard]] std::span<const ContactPoint> contactPoints() const {
        return {held.data(), static_cast<std::size_t>(contactPointCount)};
    }
};

/// Lets the proxy follow the device. The proxy never enters the tooth, from the first tick on: also when the device
/// starts inside the tooth, and when cutting changes the surface around the tool. Poses are those of the tool in the
/// tooth's frame.
class ToolProxy {
public:
    static constexpr double kTick = 0.001;  ///< s, default of `follow`

    ToolProxy(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface, ContactMode mode,
              Freedom freedom = Freedom::Translation);

    /// Moves the proxy by one tick. `goal` is how far the tool may move toward the device in this tick; `dt` is the
    /// time since the last tick, s. Both poses are rigid; the caller handles faulty readings.
    ProxyState follow(const Pose& deviceInTooth, const Pose& goal, double dt = kTick);
    ProxyState follow(const Pose& deviceInTooth) { return follow(deviceInTooth, deviceInTooth); }

    [[nodiscard]] const Pose& pose() const { return solver_.pose(); }
    /// See ProxySolver.
    [[nodiscard]] std::uint32_t ownListRebuilds() const { return solver_.ownListRebuilds(); }
    void setBudget(Work budget) { solver_.setBudget(budget); }

    [[nodiscard]] const std::shared_ptr<const ToolShape>& tool() const { return tool_; }
    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return surface_; }

    /// Takes the newest surface, not null. Returns the old one, so that the caller can free it outside of the servo
    /// thread.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface);
    /// The same with the neighbour list of HapticSurfaceBuilder. The surface and list before the present ones are left
    /// in `hapticSurface`; the present ones are kept, in case that the new surface encloses the tool. A tool without a
    /// pose takes that of `hapticSurface`. Returns false if the surface is not new; then only its list is taken.
    bool setSurface(HapticSurface& hapticSurface);

    /// From now on, a tool whose device starts inside the tooth waits for a HapticSurface with a pose: the search for a
    /// free pose takes longer than a tick. Until then no tick is placed.
    void deferPlacement() { placesItself_ = false; }

    /// Gives up the pose of the proxy: the next tick finds a new one.
    void release() { placed_ = false; }

private:
    [[nodiscard]] ProxyState followByPenalty(const Pose& deviceInTooth);
    [[nodiscard]] bool takeSurface(HapticSurface& hapticSurface);
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
    ProxySolver solver_;
    ContactQuery query_;
    bool placesItself_ = true;
    bool placed_ = false;
    bool newSurface_ = false;   // a new surface has come since the last tick
    HapticSurface other_;       // the surface before the present one, or the newest one while it cannot be used yet
    bool isAtOldPose_ = false;  // the tool has not moved since the surface before
    std::optional<double>
        waitTime_;         // s that the newest surface has waited until the tool is free in it; none: it is in use
    int failedTries_ = 0;  // to use a new surface, since the last success
    Vec3 farEnd_ = Vec3::Zero();          // end of the tool that is away from the tip
    bool touching_ = false;               // the tool was in contact at the last tick
    ContactPoint lastContact_;            // the last contact
    Vec3 exitDirection_ = Vec3::UnitZ();  // unit, direction of the last contact
};

}  // namespace tactooth

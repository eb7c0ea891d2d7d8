// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "haptics/contact_force.h"
#include "haptics/cutting_force.h"
#include "haptics/feed_rate_limiter.h"
#include "haptics/tool_proxy.h"
#include "instruments/spindle.h"

namespace tactooth {

/// What the hand and the foot do at one tick.
struct OperatorInput {
    Pose deviceInTooth;    ///< of the tool, as the device holds it
    double pedal = 0;      ///< 0 up .. 1 down
    bool cutting = false;  ///< false: touch (the bur stands still)
};

/// All that one tick has found, for the device, the recorder, the plots and the sound. Lengths mm, forces N.
struct Tick {
    double time = 0;  ///< s since the start of the simulation
    Pose hand;
    Pose proxy;
    double depth = 0;
    Vec3 normal = Vec3::Zero();      ///< unit, out of the tooth; zero without contact
    double speed = 0;                ///< of the hand's tip, mm/s
    Wrench wrench;                   ///< wanted; the force pipeline comes after
    Vec3 driveForce = Vec3::Zero();  ///< N, that part of it with which the spinning bur pulls: the drive pays for it
    double stiffness = 0;            ///< of the spring in it, N/mm; 0 without contact
    double deflection = 0;           ///< of that spring, inwards and against friction, mm
    int contacts = 0;
    bool placed = false;
    bool cutting = false;
    double pedal = 0;
    double speedRpm = 0;      ///< of the bur
    double load = 0;          ///< torque on the bur, N*mm
    double removalPower = 0;  ///< tangential force times rim speed
    double cutWork = 0;       ///< normal force times rim travel since the start, N*m: what the removal law spends
    MaterialId material{};    ///< that holds the tool most; meaningless without contact
    std::optional<MaterialId> around;   ///< of a body around the tooth, if one holds the tool
    std::uint32_t contactOnsets = 0;    ///< how often the tool has come to touch
    double impactSpeed = 0;             ///< along the normal at the last landing, mm/s
    std::uint32_t ownListRebuilds = 0;  ///< how often a tick has had to look itself for what is near
    double micros = 0;                  ///< that the tick took to compute; filled in by whoever has a clock
};

/// Of the tick of a bur that cuts. With it the slowest of a thousand ticks take some 0.2 ms of their 1 ms
/// (bench/results/2026-11-cutting.md, 2026-11-realtime.md).
inline constexpr Work kTickBudget = 25'000;

struct HapticSettings {
    MaterialTable materials;
    ForceOverrides force;
    ContactMode mode = ContactMode::Proxy;
    Freedom freedom = Freedom::Translation;
    SpindlePreset spindle = spindlePresets().front();
    Work tickBudget =
        kTickBudget;  ///< beyond which a tick of a bur that cuts leaves the rest of its way to the next one
};

/// One simulation step as a pure function of its state and the hand: equal inputs give equal ticks, bit for bit. Reads
/// no clock; allocates, locks and logs nothing. A hand that is nowhere (not a number, further away than a kilometre, a
/// rotation that is none) is not followed: such a tick is not `placed`, and the next good one goes on from the last.
class HapticSimulation {
public:
    /// `burRadius`: largest distance of the bur's blades from its axis, mm.
    HapticSimulation(std::shared_ptr<const ToolShape> tool, double burRadius, std::shared_ptr<const Surface> surface,
                     const HapticSettings& settings);

    /// `elapsed` seconds after the step before; a time that is no number is none.
    Tick step(const OperatorInput& input, double elapsed);

    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface) {
        return proxy_.setSurface(std::move(surface));
    }
    /// Takes a surface with the list that belongs to it; older ones stay in `hapticSurface`.
    void setSurface(HapticSurface& hapticSurface);
    /// See ToolProxy: for a loop that must keep its time.
    void deferPlacement() { proxy_.deferPlacement(); }
    /// For a loop that has all the time it wants: instead of HapticSettings::tickBudget.
    void setTickBudget(Work work) { tickBudget_ = work; }
    [[nodiscard]] const std::shared_ptr<const ToolShape>& tool() const { return proxy_.tool(); }
    [[nodiscard]] ContactForce& force() { return force_; }

private:
    void filterVelocity(const Pose& hand, double dt);
    void touch(const OperatorInput& input, double dt, Tick& tick);
    [[nodiscard]] Pose targetOf(const OperatorInput& input, double dt);
    [[nodiscard]] double rimSpeed() const;
    void stepBur(const OperatorInput& input, double dt, Tick& tick);

    ToolProxy proxy_;
    MaterialTable materials_;
    ContactForce force_;
    FeedRateLimiter feedLimiter_;
    CuttingForce cuttingForce_;
    SpindlePreset spindle_;
    SpindleState bur_;
    double burRadius_;
    double power_ = 0;        // of the cut at the last tick, N*m a second
    bool started_ = false;    // there is a tick to count time from
    bool following_ = false;  // there is a position to take the speed from
    bool touching_ = false;
    Vec3 lever_ = Vec3::Zero();  // from the tool's tip to where it is held, mm
    Freedom freedom_;
    Work tickBudget_;
    Pose lastDevice_;
    Vec3 velocity_ = Vec3::Zero();  // low-passed, mm/s
    Vec3 spin_ = Vec3::Zero();      // low-passed, rad/s
    Tick last_;
};

}  // namespace tactooth

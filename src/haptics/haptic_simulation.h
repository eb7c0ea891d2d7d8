// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "haptics/contact_force.h"
#include "haptics/cutting_force.h"
#include "haptics/feed_rate_limiter.h"
#include "haptics/tick.h"
#include "haptics/tip/tip_hold.h"
#include "haptics/tool_proxy.h"
#include "instruments/hand_instruments.h"
#include "instruments/spindle.h"

namespace tactooth {

/// Input of the user at one tick: device and foot pedal.
struct OperatorInput {
    Pose deviceInTooth;    ///< pose of the tool that the device asks for
    double pedal = 0;      ///< 0 up .. 1 down
    bool cutting = false;  ///< false: touch only; the bur does not turn
};

/// Work budget of a tick of a cutting bur. With it the slowest of a thousand ticks take about 0.2 ms of their 1 ms
/// (bench/results/2026-11-cutting.md, 2026-11-realtime.md).
inline constexpr Work kTickBudget = 25'000;

struct HapticSettings {
    MaterialTable materials;
    ForceOverrides force;
    ContactMode mode = ContactMode::Proxy;
    Freedom freedom = Freedom::Translation;
    SpindlePreset spindle = spindlePresets().front();
    /// Work budget of a tick of a cutting bur; the rest of its displacement follows in the next tick.
    Work tickBudget = kTickBudget;
};

/// One simulation step as a pure function of its state and the input: equal inputs give equal ticks, bit for bit. It
/// reads no clock, and allocates, locks and logs nothing. A faulty device pose (not finite, farther away than a
/// kilometre, no rotation) is not followed: the tick is not `placed`, and the next valid tick continues from the last
/// valid one.
class HapticSimulation {
public:
    /// `burRadius`: largest distance of the bur's blades from its axis, mm. Neither pointer is null.
    HapticSimulation(std::shared_ptr<const ToolShape> tool, double burRadius, std::shared_ptr<const Surface> surface,
                     const HapticSettings& settings);

    /// Computes the next tick. `elapsed` is the time since the last step, s, not negative; a time that is not finite
    /// counts as zero.
    Tick step(const OperatorInput& input, double elapsed);

    /// Takes a surface, not null. Returns the old one, so that the caller decides where it is freed.
    std::shared_ptr<const Surface> setSurface(std::shared_ptr<const Surface> surface) {
        isHoldOutdated_ = tipHold_.force() > 0;
        return proxy_.setSurface(std::move(surface));
    }
    /// Takes a surface with its neighbour list; the old ones stay in `hapticSurface`.
    void setSurface(HapticSurface& hapticSurface);
    /// For a loop in real time; see ToolProxy::deferPlacement.
    void deferPlacement() { proxy_.deferPlacement(); }
    /// The tool is this one, without a drive. Call it before the first tick. `materials`: those of the tooth.
    void holdByHand(HandInstrument kind, const MaterialTable& materials);
    /// Replaces HapticSettings::tickBudget, for a loop that is not in real time. Positive.
    void setTickBudget(Work work);
    [[nodiscard]] const std::shared_ptr<const ToolShape>& tool() const { return proxy_.tool(); }
    [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return proxy_.surface(); }
    [[nodiscard]] ContactForce& force() { return force_; }

private:
    void filterVelocity(const Pose& device, double dt);
    void touch(const OperatorInput& input, double dt, Tick& tick);
    [[nodiscard]] Pose targetOf(const OperatorInput& input, double dt);
    [[nodiscard]] double rimSpeed() const;
    [[nodiscard]] double slideSpeed(const Tick::Contact& now, double dt) const;
    [[nodiscard]] double softnessAtTip(const ProxyState& state) const;
    void updateTipHold(const ProxyState& state, double dt, Tick& tick);
    void countPullOut(Tick& tick);
    [[nodiscard]] double bladeWork(const Tick& tick, double dt) const;
    void stepBur(double dt, Tick& tick);

    ToolProxy proxy_;
    ContactForce force_;
    FeedRateLimiter feedLimiter_;
    CuttingForce cuttingForce_;
    std::optional<HandInstrument> hand_;
    std::array<double, kMaxMaterials> softness_{};  // by MaterialId
    TipHold tipHold_;
    bool isHoldOutdated_ = false;  // the tooth has changed since the tip went in
    SpindlePreset spindle_;
    SpindleState bur_;
    double burRadius_;
    double power_ = 0;        // power of the cut at the last tick, N*m a second
    bool started_ = false;    // false: no tick yet
    bool following_ = false;  // false: there is no last position to compute a speed from
    bool touching_ = false;
    Vec3 lever_ = Vec3::Zero();  // from the tool's tip to the mean contact point, mm
    Freedom freedom_;
    Work tickBudget_;
    Pose lastDevice_;
    Vec3 velocity_ = Vec3::Zero();  // low-passed, mm/s
    Vec3 spin_ = Vec3::Zero();      // low-passed, rad/s
    Tick last_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "geometry/util/triple_buffer.h"
#include "haptics/haptic_simulation.h"
#include "haptics/servo_loop.h"
#include "instruments/bur_catalogue.h"
#include "session/control/device_set.h"
#include "session/simulation/cut_model.h"
#include "session/simulation/tooth_file.h"

namespace tactooth {

/// The instrument in the hand.
struct Instrument {
    std::shared_ptr<const ToolShape> shape;
    CuttingTool cutting;
    BurEdge edge = {};
};

/// What a person sets while the simulation runs.
struct SimulatorControls {
    ForceOverrides force;  ///< none: the materials' own
    double forceScale = 1;
    double pedal = 0;          ///< 0..1, from a slider or key; the larger of this and the device's own pedal counts
    bool cutting = false;      ///< touch or cut
    bool forceEnabled = true;  ///< off: the device is limp, everything else goes on
    bool clutch = false;       ///< the tool stays where it is while the hand moves on
    double motionScaling = 1;  ///< mm that the hand moves for each mm of the tool: 3 for fine work
    ButtonMap buttons = {};
};

/// A running simulation: the servo thread moves the tool and makes the force, the cutter thread carves behind it, the
/// maker thread makes the bricks of the cut volume before the cutter needs them, the lister thread looks up what is
/// near the tool before the servo needs it, and any number of others watch. Built for one tooth, one instrument and the
/// devices of one or two hands; another of these is another simulator.
class Simulator {
public:
    using TickListener = std::function<void(const Tick&)>;

    /// `device` is open and outlives the simulator. `onTick` runs on the servo thread after every tick: it must not
    /// block (publish to the sound, for example). The work piece may bring cuts from an earlier simulator.
    /// `registration`: for a device whose frame has nothing to do with the tooth; without it the device's frame is the
    /// tooth's. `second`: a device for the other hand, which begins with the mirror; open, and outlives the simulator
    /// as well. `motionScaling`: until other controls are set.
    Simulator(std::shared_ptr<CutModel> piece, Instrument instrument, const HapticSettings& settings,
              HapticDevice& device, TickListener onTick, double rateHz = 1000,
              std::optional<DeviceRegistration> registration = {}, HapticDevice* second = nullptr,
              double motionScaling = 1);
    ~Simulator();
    Simulator(const Simulator&) = delete;
    Simulator& operator=(const Simulator&) = delete;

    /// From one thread (the window's); wait-free.
    void setControls(const SimulatorControls& controls) { controls_.write(controls); }

    /// One thread (the window's): the ticks since the last call, oldest first, appended to `ticks`. Ticks that were not
    /// fetched in time (two seconds) are lost to the plots, to nothing else.
    void fetchTicks(std::vector<Tick>& ticks);

    /// Any thread.
    [[nodiscard]] std::shared_ptr<const Surface> surface() const;
    /// The surface as files have it: see exportedMesh.
    [[nodiscard]] TaggedMesh exported() const;
    [[nodiscard]] MaterialVolumes removed() const { return loss().removed; }
    [[nodiscard]] ToothLoss loss() const;
    /// Of the tooth: what the indices of `removed` mean. Any thread.
    [[nodiscard]] const MaterialRegistry& materials() const { return model_->tooth().materials(); }
    [[nodiscard]] const ServoTiming& timing() const { return loop_->timing(); }
    /// One thread (the window's): how the hand has moved the mirror since the start, in the tooth's frame.
    [[nodiscard]] const Pose& mirrorMotion() { return mirrorForObserver_.refresh(), mirrorForObserver_.value(); }
    /// From the device's reading of a hand to the force that answers it, us.
    [[nodiscard]] const LatencyHistogram& deviceToForce() const { return deviceToForce_; }
    /// Why the hand feels what it feels.
    [[nodiscard]] ForceState forceState() const { return forceState_.load(std::memory_order_relaxed); }
    /// See Hands.
    [[nodiscard]] bool isDeviceAtWorkspaceLimit() const {
        return deviceAtWorkspaceLimit_.load(std::memory_order_relaxed);
    }
    [[nodiscard]] bool isRealTime() const { return loop_->isRealTime(); }
    [[nodiscard]] bool limitsCpuLatency() const { return loop_->limitsCpuLatency(); }
    /// Surfaces published by the cutter so far.
    [[nodiscard]] std::uint64_t surfaceUpdates() const { return surfaceUpdates_.load(std::memory_order_relaxed); }
    /// Puts the tooth back as it was. Any thread; done by the cutter thread at its next turn.
    void requestReset() { resetRequested_.store(true); }
    /// Takes back what was cut since the bur last began to cut after a pause. Any thread; done like a reset. Nothing
    /// happens if nothing was cut.
    void requestUndo() { undosRequested_.fetch_add(1); }
    /// The tooth as it is now, as the bytes of a file. Any thread but the servo's; waits for one cut at most.
    [[nodiscard]] std::vector<std::byte> toothFile(const Provenance& provenance) const;

private:
    template <std::size_t kCapacity>
    using SurfaceQueue = boost::lockfree::spsc_queue<HapticSurface*, boost::lockfree::capacity<kCapacity>>;
    static constexpr std::size_t kTickCapacity = 2048;

    /// What the cutter has made.
    struct CarvedSurface {
        std::shared_ptr<const Surface> felt;
        std::optional<Pose> reached;  ///< where the cut lets the tool go to
    };

    void servoTick(double elapsed);
    void fadeOut();
    void adoptNewSurface();
    void runCarving(const std::stop_token& stop);
    void runNeighbourLists(const std::stop_token& stop);
    void runBrickPrefetch(const std::stop_token& stop, BrickPool& pool);
    [[nodiscard]] bool processModel();
    [[nodiscard]] bool processUndoRequest();
    [[nodiscard]] bool processCutRequest();
    void publishSurface();
    [[nodiscard]] std::optional<CarvedSurface> waitForCutSurface(const std::stop_token& stop, bool idle);
    [[nodiscard]] bool send(HapticSurface* felt);

    std::shared_ptr<CutModel> model_;
    Instrument instrument_;
    HapticSettings settings_;
    double rateHz_;
    HapticDevice& device_;
    HapticDevice* second_;
    TickListener onTick_;

    // Servo thread's.
    HapticSimulation simulation_;
    DeviceSet devices_;

    // Between threads.
    TripleBuffer<SimulatorControls> controls_;
    TripleBuffer<Tick> tickForCarving_;
    TripleBuffer<Tick> tickForNeighbourLists_;
    TripleBuffer<std::optional<Pose>> carvingPose_;  // cutter -> maker; nothing while the bur only touches
    boost::lockfree::spsc_queue<Tick, boost::lockfree::capacity<kTickCapacity>> ticksForObserver_;
    SurfaceQueue<8> pendingSurfaces_;   // lister -> servo
    SurfaceQueue<32> retiredSurfaces_;  // and back, with the surface felt before: the servo never frees one
    TripleBuffer<Pose> mirrorForObserver_;
    LatencyHistogram deviceToForce_;
    std::atomic<ForceState> forceState_{ForceState::Off};
    std::atomic<bool> deviceAtWorkspaceLimit_{false};
    std::atomic<bool> fadingOut_{false};  // the force fades out
    std::atomic<bool> silent_{true};      // it has
    std::atomic<bool> resetRequested_{false};
    std::atomic<int> undosRequested_{0};
    std::atomic<std::uint64_t> surfaceUpdates_{0};

    // Cutter's.
    double lastCut_ = -std::numeric_limits<double>::infinity();  ///< Tick::time, s

    // Lister's.
    HapticSurfaceBuilder surfaces_;
    std::shared_ptr<const Surface> newest_;  ///< that it knows of

    /// The cutter's while it works, and that of anyone who looks at the work piece; never the servo's.
    mutable std::mutex modelMutex_;

    // Cutter, lister and watchers; never the servo.
    mutable std::mutex publishedMutex_;
    std::shared_ptr<const Surface> publishedSurface_;
    ToothLoss publishedLoss_;
    std::optional<CarvedSurface> surfaceToList_;
    std::condition_variable_any cutAvailable_;

    std::unique_ptr<ServoLoop> loop_;
    std::jthread carvingThread_;
    std::jthread brickPrefetchThread_;
    std::jthread neighbourListThread_;
};

}  // namespace tactooth

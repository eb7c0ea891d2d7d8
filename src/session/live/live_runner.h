// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

#include "geometry/util/triple_buffer.h"
#include "haptics/haptic_simulation.h"
#include "haptics/servo_loop.h"
#include "session/control/device_set.h"
#include "session/kernel/carving_stage.h"
#include "session/kernel/event_lanes.h"
#include "session/kernel/listing_stage.h"
#include "session/kernel/servo_stage.h"
#include "session/live/session_feed.h"
#include "session/simulation/tooth_file.h"
#include "tooth/file/tooth_snapshot.h"

namespace tactooth {

/// The controls of a running simulation.
struct SessionControls {
    ForceOverrides force;  ///< empty: the materials' own values
    double forceScale = 1;
    double pedal = 0;          ///< 0..1, from a slider or key; the larger of this and the device's pedal counts
    bool cutting = false;      ///< touch or cut
    bool forceEnabled = true;  ///< off: the device gets no force, all else goes on
    bool clutch = false;       ///< the tool stays where it is while the hand moves on
    double motionScaling = 1;  ///< mm that the hand moves for each mm of the tool: 3 for fine work
    ButtonMap buttons = {};
    std::shared_ptr<const DepthControl> depthStop{};  ///< for devices: the floor at which they stop; null: they do not
    std::shared_ptr<const WallGuide> guide{};         ///< for devices: what pushes them back; null: nothing
};

/// A running simulation of one tooth, one instrument and the devices of one or two hands. The servo thread moves the
/// tool and computes the force. The carving thread cuts behind it. The brick-prefetch thread samples bricks of the cut
/// volume before the carving thread needs them. The neighbour-list thread builds lists before the servo thread needs
/// them. Any other threads may observe.
class LiveRunner {
public:
    using TickListener = std::function<void(const Tick&)>;

    /// `device` is open and outlives the runner. `onTick` runs on the servo thread after every tick and must not
    /// block. The model may already be cut. `registration` maps the frame of the device to the tooth frame; without it
    /// both are the same. `second`: a device for the other hand, which holds the mirror at first; open, and outlives
    /// the runner. `controls` hold from the first tick until others are set; without them the tool only touches, with
    /// the force of the settings. `lanes`: where the threads report their events, for a recorder; null: nowhere.
    LiveRunner(std::shared_ptr<CutModel> piece, Instrument instrument, const HapticSettings& settings,
               HapticDevice& device, TickListener onTick, double rateHz = 1000,
               std::optional<DeviceRegistration> registration = {}, HapticDevice* second = nullptr,
               const std::optional<SessionControls>& controls = {}, std::shared_ptr<EventLanes> lanes = {});
    ~LiveRunner();
    LiveRunner(const LiveRunner&) = delete;
    LiveRunner& operator=(const LiveRunner&) = delete;

    /// One thread (the window's); wait-free.
    void setControls(const SessionControls& controls) { controls_.write(controls); }

    /// What the session shows.
    [[nodiscard]] SessionFeed& feed() { return feed_; }
    [[nodiscard]] const SessionFeed& feed() const { return feed_; }

    /// Any thread; the carving thread carries the requests out in their order, one in each turn. Reset restores the
    /// whole tooth. Undo takes back the last step: a reset, or the cut since the bur last began to cut after a pause.
    /// Redo does it again, unless something was cut since. No effect if there is nothing to reset, undo or redo.
    void request(Edit edit);
    /// The tooth as it is after all that was requested before, for a file. Any thread but the servo thread. The carving
    /// thread makes the copy, at the latest when the runner ends.
    [[nodiscard]] std::future<ToothSnapshot> snapshot();

private:
    template <std::size_t kCapacity>
    using SurfaceQueue = boost::lockfree::spsc_queue<HapticSurface*, boost::lockfree::capacity<kCapacity>>;

    /// A surface for the neighbour-list thread.
    struct Publication {
        CarvedSurface cut;
        SurfaceNumber number = 0;
    };

    void servoTick(double elapsed);
    void fadeOut();
    [[nodiscard]] std::uint32_t takeSurfaces();
    void setForce(const SessionControls& controls);
    void runCarving(const std::stop_token& stop);
    void runNeighbourLists(const std::stop_token& stop);
    void runBrickPrefetch(const std::stop_token& stop, BrickPool& pool);
    [[nodiscard]] bool processModel();
    using Request = std::variant<Edit, std::promise<ToothSnapshot>>;
    [[nodiscard]] std::optional<Request> takeRequest();
    void answer(std::promise<ToothSnapshot>& wanted) const;
    void publishSurface();
    [[nodiscard]] Publication waitForSurface(const std::stop_token& stop, bool idle);
    [[nodiscard]] std::uint32_t recycleSurfaces();
    [[nodiscard]] bool send(HapticSurface* hapticSurface);

    std::shared_ptr<CutModel> model_;
    Instrument instrument_;
    double rateHz_;
    HapticDevice& device_;
    HapticDevice* second_;
    TickListener onTick_;
    std::shared_ptr<EventLanes> lanes_;
    SessionFeed feed_;

    // Of the servo thread.
    ServoStage servo_;
    DeviceSet devices_;
    ElapsedTime elapsed_;
    double nextTickHash_ = 0;  // Tick::time, s
    ForceParameters force_;    // in use

    // Between threads.
    TripleBuffer<SessionControls> controls_;
    TripleBuffer<Tick> tickForCarving_;
    TripleBuffer<Tick> tickForNeighbourLists_;
    TripleBuffer<std::optional<Pose>>
        carvingPose_;                     // carving -> brick-prefetch thread; nothing while the bur only touches
    SurfaceQueue<8> pendingSurfaces_;     // neighbour-list -> servo thread
    SurfaceQueue<32> retiredSurfaces_;    // back, with the surface before: the servo thread frees none
    std::atomic<bool> fadingOut_{false};  // the force fades out
    std::atomic<bool> silent_{true};      // it has faded out

    CarvingStage carving_;        // of the carving thread
    double nextCarvingHash_ = 0;  // of the carving thread: Tick::time, s
    ListingStage listing_;        // of the neighbour-list thread

    mutable std::mutex requestMutex_;  // of the carving thread and those who ask; never of the servo thread
    std::deque<Request> requested_;

    mutable std::mutex publishedMutex_;  // of the carving thread and the neighbour-list thread
    std::optional<Publication> surfaceToList_;
    SurfaceNumber published_ = 0;
    std::condition_variable_any cutAvailable_;

    std::unique_ptr<ServoLoop> loop_;
    std::jthread carvingThread_;
    std::jthread brickPrefetchThread_;
    std::jthread neighbourListThread_;
};

}  // namespace tactooth

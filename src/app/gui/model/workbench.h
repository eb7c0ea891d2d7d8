// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/model/bench_parts.h"
#include "app/gui/model/errand.h"
#include "app/gui/input/hand_control.h"
#include "devices/mouse_device.h"
#include "devices/workspace_fit.h"
#include "session/simulation/cut_events.h"
#include "session/simulation/spray_cloud.h"
#include "sound/output/sound_output.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {

/// The simulation as the window handles it: the tooth and the bur on the bench, those that are being made, the running
/// simulator and the hand. Everything is called from the window's thread and returns at once; no call waits for the
/// servo. Knows no widgets.
class Workbench {
public:
    /// `sound` outlives the bench.
    explicit Workbench(SoundOutput& sound);
    ~Workbench();
    Workbench(const Workbench&) = delete;
    Workbench& operator=(const Workbench&) = delete;

    void bring(Errand<BenchTooth>::Work tooth) { comingTooth_.start(std::move(tooth)); }
    void bring(Errand<BenchBur>::Work bur) { comingBur_.start(std::move(bur)); }
    void put(BenchTooth tooth);
    void put(BenchBur bur);
    /// Ends the simulator; tooth and bur stay.
    void stop() { simulator_.reset(); }
    void setSpindle(const SpindlePreset& spindle);
    /// An open device that moves the tool from now on, instead of the mouse.
    void put(std::unique_ptr<HapticDevice> device);
    /// The mouse moves it again; the device is closed.
    void useMouse();
    /// See HapticDevice.
    void letDeviceRest(bool rests) {
        if (device_) device_->letRest(rests);
    }
    /// None: the mouse.
    [[nodiscard]] const HapticDevice* device() const { return device_.get(); }
    /// That of the other hand; none if it is empty.
    [[nodiscard]] const HapticDevice* secondDevice() const { return second_.get(); }
    /// Handles leave to the other side.
    void setLeftHanded(bool leftHanded);
    [[nodiscard]] bool isLeftHanded() const { return leftHanded_; }
    /// Touch or cut, as a person chooses it on the screen; a button of the device may have chosen before.
    void setCutting(bool cutting);
    /// An open device for the other hand, which begins with the mirror; null: that hand is empty.
    void putSecond(std::unique_ptr<HapticDevice> device);
    [[nodiscard]] const SpindlePreset& spindle() const { return settings_.spindle; }
    [[nodiscard]] const MaterialTable& materials() const { return settings_.materials; }

    /// Hz of the servo.
    void setRate(double rateHz);
    [[nodiscard]] double rate() const { return rate_; }

    /// What has happened since the last step.
    struct News {
        bool newTooth = false;
        bool newSimulator = false;           ///< time starts at zero again
        std::optional<std::string> failure;  ///< a sentence; what was on the bench stays
        std::optional<double> heavyTick;     ///< us, if the scene turns out to be heavy: slowTick
        /// What ails a device, if that has changed; null: nothing any more. The session goes on.
        std::optional<const char*> trouble;
    };
    /// Call at least as often as the picture changes. `dt`: since the last step, s.
    [[nodiscard]] News step(double dt);

    [[nodiscard]] bool isBusy() const { return comingTooth_.isBusy() || comingBur_.isBusy() || furniture_.isBusy(); }
    [[nodiscard]] const std::optional<BenchTooth>& tooth() const { return tooth_; }
    [[nodiscard]] const std::optional<BenchBur>& bur() const { return bur_; }
    /// None until there are a tooth and a bur.
    [[nodiscard]] Simulator* simulator() { return simulator_.get(); }

    /// All that the bur can touch now. Needs a simulator.
    [[nodiscard]] std::shared_ptr<const Surface> felt() const;

    /// As fine as the devices can work and still reach all of the tooth and as far around it as the mouse does; none
    /// without a tooth, or where no device has a room of its own.
    [[nodiscard]] std::optional<WorkspaceFit> fit() const;
    /// Takes the fineness of that fit instead of that of the controls. A device that moves the tool from then on, and
    /// whose room is known, has the tooth in its middle.
    void letFit(bool fits) { fits_ = fits; }
    /// The one that counts.
    [[nodiscard]] double fineness() const;

    /// Taken over by the simulator at the next step. Fineness and clutch are a device's alone: the mouse points.
    SimulatorControls controls;
    /// Whether water flows with the pedal, and whether an assistant holds the suction tube: seen and heard.
    void setWater(bool flows) { water_ = flows; }
    void setSuction(bool draws) { suction_ = draws; }
    /// The mouth mirror: `diameter` of its head (mm), and what is on the glass.
    void setMirror(double diameter, bool fogged, bool wet);
    [[nodiscard]] std::span<const FlyingBit> flying() const { return spray_.bits(); }
    /// Puts the tooth back as it was.
    void resetTooth();
    /// What has happened to the tooth since it was brought or put back; times go on from one bur to the next.
    [[nodiscard]] const CutEvents& events() const { return events_; }
    /// Since the first contact, s; 0 before.
    [[nodiscard]] double workSeconds() const;
    HandControl& hand() { return hand_; }
    [[nodiscard]] const Tick& newest() const { return newest_; }
    /// The ticks of the last step, oldest first.
    [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

    /// Direction of mesial along x.
    [[nodiscard]] double mesialX() const { return tooth_ ? tooth_->mesialX : 1; }
    /// From buccal and above, as a dentist sees a lower tooth; the parked mirror is turned to it.
    [[nodiscard]] OrbitCamera::Direction usualView() const;
    /// All but the camera.
    [[nodiscard]] SceneContents contents(bool withTurbine, bool withMirror) const;

private:
    void startSimulator(News& news);
    void takeHand();
    [[nodiscard]] Quat handTurn() const;
    [[nodiscard]] Box3 reached() const;
    [[nodiscard]] std::optional<Seat> seat() const;
    [[nodiscard]] double handleX() const { return leftHanded_ ? -mesialX() : mesialX(); }
    void takeDeliveries(News& news);
    void reportTrouble(News& news);
    void spray(double dt);
    void beginEvents();
    void watchTicks();
    void addSurroundings(SceneContents& contents, bool withMirror) const;

    SoundOutput& sound_;
    HapticSettings settings_;
    double rate_ = 1000;  // Hz
    Errand<BenchTooth> comingTooth_;
    Errand<BenchBur> comingBur_;
    Errand<BenchFurniture> furniture_;
    std::optional<BenchTooth> tooth_;
    std::optional<BenchBur> bur_;
    std::optional<BenchFurniture> around_;
    bool simulatorIsOld_ = false;
    bool toothIsNew_ = false;
    bool leftHanded_ = false;
    bool fits_ = false;
    HandControl hand_;
    MouseDevice mouse_;
    std::unique_ptr<HapticDevice> device_;  // none: the mouse
    std::unique_ptr<HapticDevice> second_;  // none: one hand alone
    const char* trouble_ = nullptr;         // of the devices, as it was reported last
    bool saidHeavy_ = false;                // that the scene is
    std::vector<Tick> ticks_;
    Tick newest_;
    CutEvents events_;
    double timeBefore_ = 0;  // of the simulators before this one, since the events began, s
    double spin_ = 0;        // rad
    SprayCloud spray_;
    struct {
        double diameter = 22;  // mm
        bool fogged = false, wet = false;
    } mirror_;
    std::atomic<bool> water_{true}, suction_{false};  // the servo reads them for the sound
    std::unique_ptr<Simulator> simulator_;            // last: it uses all of the above
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/input/mouse_manipulator.h"
#include "app/gui/model/session_parts.h"
#include "app/gui/model/task.h"
#include "devices/mouse_device.h"
#include "devices/workspace_fit.h"
#include "geometry/util/expected.h"
#include "session/simulation/cut_events.h"
#include "session/simulation/spray_particle_system.h"
#include "sound/output/sound_output.h"
#include "view/camera/orbit_camera.h"

namespace tactooth {

/// The simulation as the window handles it: the tooth and the bur on the bench, those that are being made, the running
/// simulator and the hand. Everything is called from the window's thread and returns at once; no call waits for the
/// servo. Knows no widgets.
class SessionModel {
public:
    /// `sound` outlives the model.
    explicit SessionModel(SoundOutput& sound);
    ~SessionModel();
    SessionModel(const SessionModel&) = delete;
    SessionModel& operator=(const SessionModel&) = delete;

    void load(Task<SessionTooth>::Function tooth) { pendingTooth_.start(std::move(tooth)); }
    void load(Task<SessionBur>::Function bur) { pendingBur_.start(std::move(bur)); }
    void install(SessionTooth tooth);
    void install(SessionBur bur);
    /// Ends the simulator; tooth and bur stay.
    void stop() { simulator_.reset(); }
    void setSpindle(const SpindlePreset& spindle);
    /// An open device that moves the tool from now on, instead of the mouse.
    void install(std::unique_ptr<HapticDevice> device);
    /// The mouse moves it again; the device is closed.
    void useMouse();
    /// See HapticDevice.
    void setDeviceResting(bool rests) {
        if (device_) device_->suspendInput(rests);
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
    void installSecond(std::unique_ptr<HapticDevice> device);
    [[nodiscard]] const SpindlePreset& spindle() const { return settings_.spindle; }
    [[nodiscard]] const MaterialTable& materials() const { return settings_.materials; }

    /// Hz of the servo.
    void setRate(double rateHz);
    [[nodiscard]] double rate() const { return rate_; }

    /// What has happened since the last step.
    struct StepResult {
        bool newTooth = false;
        bool newSimulator = false;        ///< time starts at zero again
        std::optional<Error> failure;     ///< what was on the bench stays
        std::optional<double> heavyTick;  ///< us, if the scene turns out to be heavy: tickP99
        /// What ails a device, if that has changed; null: nothing any more. The session goes on.
        std::optional<const Message*> faultMessage;
    };
    /// Call at least as often as the picture changes. `dt`: since the last step, s.
    [[nodiscard]] StepResult step(double dt);

    [[nodiscard]] bool isBusy() const {
        return pendingTooth_.isBusy() || pendingBur_.isBusy() || pendingInstruments_.isBusy();
    }
    [[nodiscard]] const std::optional<SessionTooth>& tooth() const { return tooth_; }
    [[nodiscard]] const std::optional<SessionBur>& bur() const { return bur_; }
    /// None until there are a tooth and a bur.
    [[nodiscard]] Simulator* simulator() { return simulator_.get(); }

    /// All that the bur can touch now. Needs a simulator.
    [[nodiscard]] std::shared_ptr<const Surface> felt() const;

    /// As fine as the devices can work and still reach all of the tooth and as far around it as the mouse does; none
    /// without a tooth, or where no device has a room of its own.
    [[nodiscard]] std::optional<WorkspaceFit> fit() const;
    /// Takes the fineness of that fit instead of that of the controls. A device that moves the tool from then on, and
    /// whose room is known, has the tooth in its middle.
    void setAutoScaling(bool fits) { autoScaling_ = fits; }
    /// The one that counts.
    [[nodiscard]] double motionScaling() const;

    /// Taken over by the simulator at the next step. Fineness and clutch are a device's alone: the mouse points.
    SimulatorControls controls;
    /// Whether water flows with the pedal, and whether an assistant holds the suction tube: seen and heard.
    void setWater(bool flows) { water_ = flows; }
    void setSuction(bool draws) { suction_ = draws; }
    /// The mouth mirror: `diameter` of its head (mm), and what is on the glass.
    void setMirror(double diameter, bool fogged, bool wet);
    [[nodiscard]] std::span<const SprayParticle> flying() const { return spray_.particles(); }
    /// Puts the tooth back as it was.
    void resetTooth();
    /// What has happened to the tooth since it was brought or put back; times go on from one bur to the next.
    [[nodiscard]] const CutEvents& events() const { return events_; }
    /// Since the first contact, s; 0 before.
    [[nodiscard]] double workSeconds() const;
    MouseManipulator& manipulator() { return manipulator_; }
    [[nodiscard]] const Tick& newest() const { return newest_; }
    /// The ticks of the last step, oldest first.
    [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

    /// Direction of mesial along x.
    [[nodiscard]] double mesialX() const { return tooth_ ? tooth_->mesialX : 1; }
    /// From buccal and above, as a dentist sees a lower tooth; the parked mirror is turned to it.
    [[nodiscard]] OrbitCamera::Direction defaultView() const;
    /// All but the camera.
    [[nodiscard]] SceneContents contents(bool withTurbine, bool withMirror) const;

private:
    void startSimulator(StepResult& stepResult);
    void readManipulator();
    [[nodiscard]] Quat manipulatorRotation() const;
    [[nodiscard]] Box3 reached() const;
    [[nodiscard]] std::optional<DeviceRegistration> registration() const;
    [[nodiscard]] double handleX() const { return leftHanded_ ? -mesialX() : mesialX(); }
    void collectFinishedTasks(StepResult& stepResult);
    void reportDeviceTrouble(StepResult& stepResult);
    void spray(double dt);
    void beginEvents();
    void watchTicks();
    void addSurroundings(SceneContents& contents, bool withMirror) const;

    SoundOutput& sound_;
    HapticSettings settings_;
    double rate_ = 1000;  // Hz
    Task<SessionTooth> pendingTooth_;
    Task<SessionBur> pendingBur_;
    Task<SessionInstruments> pendingInstruments_;
    std::optional<SessionTooth> tooth_;
    std::optional<SessionBur> bur_;
    std::optional<SessionInstruments> around_;
    bool simulatorIsOld_ = false;
    bool toothIsNew_ = false;
    bool leftHanded_ = false;
    bool autoScaling_ = false;
    MouseManipulator manipulator_;
    MouseDevice mouse_;
    std::unique_ptr<HapticDevice> device_;      // none: the mouse
    std::unique_ptr<HapticDevice> second_;      // none: one hand alone
    const Message* reportedTrouble_ = nullptr;  // of the devices, as it was reported last
    bool reportedHeavy_ = false;                // that the scene is
    std::vector<Tick> ticks_;
    Tick newest_;
    CutEvents events_;
    double timeBefore_ = 0;  // of the simulators before this one, since the events began, s
    double spin_ = 0;        // rad
    SprayParticleSystem spray_;
    struct {
        double diameter = 22;  // mm
        bool fogged = false, wet = false;
    } mirror_;
    std::atomic<bool> water_{true}, suction_{false};  // the servo reads them for the sound
    std::unique_ptr<Simulator> simulator_;            // last: it uses all of the above
};

}  // namespace tactooth

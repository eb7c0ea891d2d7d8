// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "session/hands/device_slots.h"
#include "session/hands/mirror_placement.h"
#include "session/hands/mouse_surroundings.h"
#include "session/model/device_aids.h"
#include "session/model/instrument_set.h"
#include "session/model/scene_animation.h"
#include "session/model/session_keeper.h"
#include "session/model/session_tooth.h"
#include "session/model/tick_log.h"
#include "session/model/tick_output.h"
#include "session/model/work_history.h"

namespace tactooth {

/// How the user's hands work with the devices.
struct HandSettings {
    double rate = 1000;        ///< of the servo, Hz
    bool leftHanded = false;   ///< handles leave to the other side
    bool autoScaling = false;  ///< motion scaling by SessionModel::fit instead of by the controls
};

/// A session: the tooth and the bur, the devices of both hands, the other instruments, and the running
/// runner. All functions are for one thread and return at once; none waits for the servo. A change that needs
/// another runner takes effect in the next step.
class SessionModel {
public:
    /// `sound` outlives the model. `executor` makes the meshes of the instruments.
    explicit SessionModel(SoundOutput& sound, const TaskExecutor& executor = runInThread);

    void install(SessionTooth tooth);
    void install(SessionBur bur);
    /// Puts an open device into a slot; null: the mouse moves the tool again, or the second hand is empty.
    void install(DeviceSlot slot, std::unique_ptr<HapticDevice> device);
    void setSpindle(const SpindlePreset& spindle);
    void setHand(const HandSettings& hand);
    [[nodiscard]] const HandSettings& hand() const { return hand_; }
    /// Touch or cut, as the user chooses it on the screen. A button of the device may have chosen before.
    void setCutting(bool cutting);
    /// Stops the runner; tooth and bur stay.
    void stop();
    /// Stops the runner, and starts none until it is called with false: the tooth, the bur and the devices stay.
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return paused_; }
    /// Puts the tooth back as it was before any cut. It can be undone.
    void resetTooth();

    /// What was done with the tooth.
    [[nodiscard]] const WorkHistory& history() const { return history_; }
    /// The next tooth that is installed comes with this history, from another model.
    void adopt(WorkHistory history) { adoptedHistory_ = std::move(history); }
    /// Undo, redo and jumps take effect in the next steps, in their order.
    void undo() {
        if (!isExamination_) history_.undo();
    }
    void redo() {
        if (!isExamination_) history_.redo();
    }
    void goTo(std::size_t position) {
        if (!isExamination_) history_.goTo(position);
    }
    /// Goes back to where the undo, redo or jump that is under way began.
    void giveUpHistory() { history_.giveUp(); }
    /// In an examination nothing can be taken back (undo, redo, jumps, resetTooth), no device has an aid, and no tick
    /// goes to a stream.
    void setExamination(bool on);
    [[nodiscard]] bool isExamination() const { return isExamination_; }
    /// What helps a hand that feels force, as the user has chosen.
    [[nodiscard]] DeviceAids& aids() { return aids_; }
    /// From the next tick on, each tick goes there, too. Null: nowhere.
    void streamTo(std::shared_ptr<LiveStream> stream);
    /// A change that is no cut was made; its functions undo and redo it.
    void noteChange(WorkStep step);

    /// Records the session from the next tooth on; a tooth that nobody has touched yet is recorded at once. `seal`:
    /// signs the recordings; null: nobody does.
    void recordTo(const RecordingFolder& folder, std::shared_ptr<const SigningKey> seal = {});
    /// Records nothing any more; what was recorded is kept.
    void stopRecording();
    [[nodiscard]] bool isRecording() const { return keeper_->isRecording(); }
    /// Whether the recording that runs is signed.
    [[nodiscard]] bool isSealing() const { return keeper_->isSealing(); }
    /// What somebody is doing, for the recording (workText).
    void describeWork(const std::string& work) { keeper_->describe(work); }
    /// How the mirror is held now, for the recording. Call it after each step.
    void noteMirror(const MirrorSight& sight) { keeper_->noteMirror(sight); }
    /// See SessionKeeper::setEnding; it holds for the recordings of this model.
    void setRecordingEnding(std::function<SessionKeeper::Kept()> ending);
    /// Stops the runner, ends the recording and waits until it is on the disk: the program ends.
    void finishRecording();
    /// Stops the runner, and gives the file with the recording of the tooth so far, which may go on afterwards. Waits
    /// for the disk. Empty: nothing was recorded, or not all of it.
    [[nodiscard]] std::filesystem::path writtenRecording();
    /// For another model that goes on with this tooth: the recording that runs. Stops the runner.
    [[nodiscard]] std::unique_ptr<SessionKeeper> releaseKeeper();
    /// Goes on with the recording of another model. Call it before the tooth is installed.
    void adopt(std::unique_ptr<SessionKeeper> keeper);

    /// Whether an instrument has touched the tooth since it came.
    [[nodiscard]] bool isTouched() const { return tooth_ && isTouched_; }
    /// Whether the tooth has cuts that were neither saved nor exported.
    [[nodiscard]] bool isModified() const;
    /// The tooth was saved or exported as it was when `removed` was gone. What is cut while a file is written is
    /// unsaved.
    void markSaved(const MaterialVolumes& removed);

    /// What has changed in a step.
    struct StepResult {
        bool newTooth = false;
        bool newRunner = false;           ///< the times of ticks start at zero again
        std::optional<double> heavyTick;  ///< tickP99 in us, once for each runner that turns out to be overloaded
        std::optional<const Message*> faultMessage;  ///< of a device, if it has changed; null: no fault any more
        std::optional<Message> recordingFault;       ///< why recording has stopped or could not begin, once
        bool recordingResumed = false;               ///< after such a fault it goes on in another file
    };
    /// Call it at least as often as the picture changes. `dt`: since the last step, s.
    [[nodiscard]] StepResult step(double dt);

    [[nodiscard]] const std::optional<SessionTooth>& tooth() const { return tooth_; }
    [[nodiscard]] const std::optional<SessionBur>& bur() const { return bur_; }
    /// Whether a runner will begin as soon as its recording has.
    [[nodiscard]] bool isPreparing() const { return needsRunner_ && !paused_ && tooth_ && bur_; }
    /// Null until there are a tooth and a bur, and while a recording begins.
    [[nodiscard]] LiveRunner* runner() const { return runner_.get(); }
    /// Direction of mesial along x.
    [[nodiscard]] double mesialX() const { return tooth_ ? tooth_->mesialX : 1; }
    /// The motion scaling with which the devices reach all of the tooth and as far around it as the mouse does; none
    /// without a tooth, or if no device has a bounded workspace.
    [[nodiscard]] std::optional<WorkspaceFit> fit() const;
    /// The motion scaling in use.
    [[nodiscard]] double motionScaling() const;

    [[nodiscard]] const HapticSettings& haptics() const { return haptics_; }
    [[nodiscard]] MouseManipulator& manipulator() { return manipulator_; }
    [[nodiscard]] const MouseManipulator& manipulator() const { return manipulator_; }
    /// The button of the mouse goes up: from the next tick on the bur cuts nothing.
    void releaseHand();
    /// The mouth mirror as the mouse holds it; a device moves it from there.
    [[nodiscard]] MirrorPlacement& mirror() { return mirror_; }
    [[nodiscard]] const MirrorPlacement& mirror() const { return mirror_; }
    [[nodiscard]] DeviceSlots& devices() { return devices_; }
    [[nodiscard]] const DeviceSlots& devices() const { return devices_; }
    [[nodiscard]] InstrumentSet& instruments() { return instruments_; }
    [[nodiscard]] const InstrumentSet& instruments() const { return instruments_; }
    [[nodiscard]] const TickLog& log() const { return log_; }
    [[nodiscard]] const SceneAnimation& animation() const { return animation_; }

    /// The runner takes them over in the next step. Motion scaling and clutch are for devices only: the mouse
    /// points.
    SessionControls controls;

private:
    [[nodiscard]] bool prepareRecording();
    void continueRecording();
    void noteTouches();
    [[nodiscard]] ToothLoss followHistory();
    void advanceHistory();
    void startRunner();
    void resetManipulator();
    void advanceDepthControl();
    void reportOverload(StepResult& stepResult);
    [[nodiscard]] SessionControls currentControls() const;
    [[nodiscard]] std::optional<DeviceRegistration> registration() const;

    std::vector<Tick> fetched_;  // empty between steps; keeps its memory
    HapticSettings haptics_;
    HandSettings hand_;
    std::optional<SessionTooth> tooth_;
    std::optional<SessionBur> bur_;
    bool needsRunner_ = false;  // another one than the running one
    bool isToothNew_ = false;
    bool reportedOverload_ = false;
    MouseManipulator manipulator_;
    MirrorPlacement mirror_;
    MouseSurroundings surroundings_;
    DeviceSlots devices_;
    DeviceAids aids_;
    InstrumentSet instruments_;
    TickOutput output_;
    TickLog log_;
    SceneAnimation animation_;
    bool paused_ = false;
    bool isExamination_ = false;
    WorkHistory history_;
    std::optional<WorkHistory> adoptedHistory_;
    bool isTouched_ = false;  // the tooth, by an instrument
    double touchedAt_ = 0;    // Tick::time of the newest contact, or when the runner began, s
    std::unique_ptr<SessionKeeper> keeper_;
    std::function<SessionKeeper::Kept()> recordingEnding_;
    std::unique_ptr<LiveRunner> runner_;  // last: it uses the members above
};

/// All that the bur can touch now. Needs a runner.
[[nodiscard]] std::shared_ptr<const Surface> touchableSurface(const SessionModel& model);

/// Direction along x in which the handles leave.
[[nodiscard]] double handleX(const SessionModel& model);

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_model.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "haptics/overload_check.h"
#include "session/hands/instrument_poses.h"

namespace tactooth {
namespace {

constexpr double kHandRests = 0.3;  // s without contact: nobody feels that the force ends for a moment

const Box3 kNoTooth(Vec3(-5, -5, -5), Vec3(5, 5, 5));  // mm; the hand starts above it while there is no tooth

}  // namespace

SessionModel::SessionModel(SoundOutput& sound, const TaskExecutor& executor)
    : manipulator_(kNoTooth, 1),
      devices_(manipulator_.pose()),
      instruments_(executor),
      output_(sound, instruments_),
      keeper_(std::make_unique<SessionKeeper>(executor)) {}

void SessionModel::install(SessionTooth tooth) {
    tooth_ = std::move(tooth);
    if (!tooth_->savedAt) tooth_->savedAt = tooth_->piece->removed();
    resetManipulator();
    mirror_.reset();
    haptics_.materials = MaterialTable(tooth_->piece->tooth().materials());
    if (tooth_->bur) install(*tooth_->bur);
    needsRunner_ = isToothNew_ = true;
}

/// The hand starts above the tooth again; how it presses stays. The mirror waits where this hand would hold it.
void SessionModel::resetManipulator() {
    MouseManipulator next(tooth_ ? tooth_->box() : kNoTooth, handleX(*this));
    next.setPressDepth(manipulator_.pressDepth());
    next.setPressMode(manipulator_.chosenPressMode());
    next.setHoldsHandInstrument(bur_ && bur_->isHandInstrument());
    next.depthControl() = manipulator_.depthControl();
    manipulator_ = std::move(next);
    surroundings_.forget();
    const Vec3 toEye = directionToEye(tooth_ ? chairViewOf(*tooth_).view : dentistView(mesialX()));
    if (tooth_) mirror_.park(parkedMirror(tooth_->box(), toEye, handleX(*this)));
}

/// The depth of a flat floor counts from where a cavity is begun, by a device as by the mouse.
void SessionModel::advanceDepthControl() {
    DepthControl& control = manipulator_.depthControl();
    control.setSurface(tooth_->piece->tooth().ownOuter());
    const Tick& newest = log_.newest();
    if (newest.contact.triangles == 0 || !newest.input.cutting) return;
    control.beginAt(newest.contact.proxy.position, newest.contact.proxy.rotation * -Vec3::UnitZ());
}

void SessionModel::install(SessionBur bur) {
    bur_ = std::move(bur);
    manipulator_.setHoldsHandInstrument(bur_->isHandInstrument());
    needsRunner_ = true;
    aids_.setBur(*bur_);
}

void SessionModel::install(DeviceSlot slot, std::unique_ptr<HapticDevice> device) {
    const HapticDevice* const before = slot == DeviceSlot::First ? devices_.first() : devices_.second();
    if (device == nullptr && before == nullptr) return;
    stop();  // it uses the device before
    devices_.set(slot, std::move(device));
    needsRunner_ = true;
}

void SessionModel::setSpindle(const SpindlePreset& spindle) {
    haptics_.spindle = spindle;
    needsRunner_ = true;
}

void SessionModel::setHand(const HandSettings& hand) {
    const HandSettings before = std::exchange(hand_, hand);
    if (hand.rate != before.rate) needsRunner_ = true;
    if (hand.leftHanded == before.leftHanded) return;
    resetManipulator();
    if (devices_.first() != nullptr) needsRunner_ = true;  // the device is registered anew
}

void SessionModel::setCutting(bool cutting) {
    const bool chosenByButton = log_.newest().input.cutting != controls.cutting;
    controls.cutting = cutting != (devices_.first() != nullptr && chosenByButton);
}

void SessionModel::setPaused(bool paused) {
    if (std::exchange(paused_, paused) == paused) return;
    stop();
    needsRunner_ = true;
}

void SessionModel::stop() {
    runner_.reset();
    keeper_->end();
}

void SessionModel::recordTo(const RecordingFolder& folder, std::shared_ptr<const SigningKey> seal) {
    const bool isSealed = seal != nullptr;
    keeper_->setFolder(folder, std::move(seal));
    if (!tooth_ || isTouched_ || (keeper_->isRecording() && keeper_->isSealing() == isSealed)) return;
    stop();
    needsRunner_ = true;
    keeper_->forget();
}

void SessionModel::setExamination(bool on) {
    isExamination_ = on;
    output_.setStreamAllowed(!on);
}

void SessionModel::streamTo(std::shared_ptr<LiveStream> stream) {
    output_.streamTo(std::move(stream));
    if (runner_ == nullptr) return;
    stop();  // its servo thread uses the stream before
    needsRunner_ = true;
}

void SessionModel::stopRecording() {
    if (!keeper_->folder()) return;
    if (keeper_->isRecording()) {
        stop();
        needsRunner_ = true;
    }
    keeper_->setFolder(std::nullopt);
}

void SessionModel::finishRecording() {
    stop();
    keeper_->finish();
}

std::filesystem::path SessionModel::writtenRecording() {
    if (runner_ != nullptr) needsRunner_ = true;
    stop();
    return keeper_->writtenFile();
}

std::unique_ptr<SessionKeeper> SessionModel::releaseKeeper() {
    stop();
    keeper_->setEnding(nullptr);
    auto released = std::exchange(keeper_, std::make_unique<SessionKeeper>());
    keeper_->setEnding(recordingEnding_);
    return released;
}

void SessionModel::adopt(std::unique_ptr<SessionKeeper> keeper) {
    keeper_ = std::move(keeper);
    keeper_->setEnding(recordingEnding_);
}

void SessionModel::setRecordingEnding(std::function<SessionKeeper::Kept()> ending) {
    recordingEnding_ = std::move(ending);
    keeper_->setEnding(recordingEnding_);
}

bool SessionModel::isModified() const {
    if (!tooth_) return false;
    // While a tooth is on its way in, the runner is that of the one before.
    const bool isRunning = runner_ != nullptr && !isToothNew_;
    const MaterialVolumes removed = isRunning ? runner_->feed().removed() : tooth_->piece->removed();
    return total(removed) > 0 && removed != tooth_->savedAt;  // a whole tooth is no loss
}

void SessionModel::markSaved(const MaterialVolumes& removed) {
    if (tooth_) tooth_->savedAt = removed;
}

void SessionModel::resetTooth() {
    if (runner_ == nullptr || isExamination_) return;
    runner_->request(Edit::Reset);
    // Otherwise the history takes back what belongs to the cuts, when the tooth is whole again.
    constexpr double kAll = std::numeric_limits<double>::infinity();
    if (total(runner_->feed().removed()) == 0) (void)log_.events().takeBack(0, kAll);
}

void SessionModel::noteChange(WorkStep step) {
    step.time = log_.seconds();
    history_.add(std::move(step));
}

/// Returns the loss that belongs to the history. The history comes before the ticks: what was undone or redone must not
/// be reported as a new event.
ToothLoss SessionModel::followHistory() {
    std::shared_ptr<const CutHistory> cuts;
    ToothLoss loss;
    do {
        cuts = runner_->feed().history();
        loss = runner_->feed().loss();
    } while (cuts != runner_->feed().history());
    history_.follow(*cuts, log_.events(), log_.seconds(), log_.simulatorBegan());
    return loss;
}

void SessionModel::advanceHistory() {
    const std::optional<Edit> edit = history_.advance();
    if (!edit || runner_ == nullptr) return;
    keeper_->allow(*edit, *runner_->feed().history());
    runner_->request(*edit);
}

std::optional<WorkspaceFit> SessionModel::fit() const {
    if (!tooth_) return std::nullopt;
    return devices_.fit(handWorkspace(tooth_->box()), deviceRotation(mesialX()));
}

double SessionModel::motionScaling() const {
    if (devices_.first() == nullptr || devices_.first()->info().isInToothFrame) return 1;
    return hand_.autoScaling ? fit().value_or(WorkspaceFit()).motionScaling : controls.motionScaling;
}

std::optional<DeviceRegistration> SessionModel::registration() const {
    return devices_.registration(manipulator_.pose(), handWorkspace(tooth_->box()), deviceRotation(mesialX()),
                                 hand_.autoScaling);
}

/// Whether the runner may begin: the recording has, or there is none.
bool SessionModel::prepareRecording() {
    if (isToothNew_ || !keeper_->isReady()) stop();  // it works on the tooth before
    SessionWork before = tooth_->work;
    before.title = tooth_->name;
    before.mouthTooth = tooth_->mouthTooth;
    before.isUnsaved = tooth_->wasUnsaved;
    keeper_->prepare(tooth_->piece, tooth_->name, workText(before));
    return keeper_->isReady();
}

/// A recording that has stopped goes on in another file, which begins with the tooth as it is now. That needs another
/// runner, as another bur does, so it waits until the hand rests.
void SessionModel::continueRecording() {
    if (runner_ == nullptr || needsRunner_ || !keeper_->canBeginPart()) return;
    const bool isResting =
        log_.newest().time > touchedAt_ + kHandRests && !manipulator_.isPressing() && !history_.isBusy();
    if (!isResting && !keeper_->isPartOverdue()) return;
    tooth_->wasUnsaved = isModified();
    tooth_->work.seconds = log_.seconds();
    tooth_->work.events = log_.events().all();
    tooth_->work.isUnsaved = tooth_->wasUnsaved;
    stop();
    tooth_->piece->reopen();
    keeper_->beginPart(tooth_->work, tooth_->piece->history());
    needsRunner_ = true;
}

void SessionModel::startRunner() {
    needsRunner_ = false;
    touchedAt_ = 0;
    manipulator_.release();
    devices_.moveMouse(manipulator_.pose());
    stop();  // its threads end before the new ones begin: they share the cut model and the device
    runner_ = std::make_unique<LiveRunner>(
        tooth_->piece, bur_->instrument, haptics_, devices_.active(), output_.listener(haptics_, bur_->instrument.edge),
        hand_.rate, registration(), devices_.second(), currentControls(), keeper_->begin({bur_->instrument, haptics_}));
    reportedOverload_ = false;
    Tick start;
    start.input.cutting = controls.cutting;
    start.contact.proxy = start.input.device = manipulator_.pose();
    log_.restart(start);
    animation_.restart(bur_->instrument.cutting.envelope.maxRadius(),
                       parkedSuction(tooth_->box(), tooth_->mesialX).position);
}

void SessionModel::reportOverload(StepResult& stepResult) {
    if (reportedOverload_ || !isOverloaded(runner_->feed().timing(), hand_.rate)) return;
    reportedOverload_ = true;
    stepResult.heavyTick = tickP99(runner_->feed().timing());
}

void SessionModel::noteTouches() {
    const auto touches = [](const Tick& tick) { return tick.contact.triangles > 0; };
    const std::vector<Tick>& ticks = log_.ticks();
    const auto last = std::find_if(ticks.rbegin(), ticks.rend(), touches);
    if (last == ticks.rend()) return;
    touchedAt_ = last->time;
    isTouched_ = true;
    keeper_->noteTouch();
}

SessionControls SessionModel::currentControls() const {
    SessionControls now = controls;
    now.motionScaling = motionScaling();
    now.clutch = devices_.first() != nullptr && controls.clutch;
    if (devices_.first() == nullptr) now.cutting = now.cutting && manipulator_.mayCut();
    if (devices_.first() != nullptr && !isExamination_) aids_.addTo(now, manipulator_.depthControl());
    return now;
}

void SessionModel::releaseHand() {
    manipulator_.release();
    if (runner_ != nullptr) runner_->setControls(currentControls());
}

SessionModel::StepResult SessionModel::step(double dt) {
    StepResult stepResult;
    instruments_.poll();
    stepResult.recordingFault = keeper_->takeFault();
    continueRecording();
    if (needsRunner_ && !paused_ && tooth_ && bur_ && prepareRecording()) {
        startRunner();
        stepResult.newRunner = true;
        stepResult.recordingResumed = keeper_->takeResumed();
        stepResult.newTooth = std::exchange(isToothNew_, false);
        if (stepResult.newTooth) {
            log_.clearEvents(haptics_.materials.registry(), tooth_->work);
            history_.clear();
            if (adoptedHistory_) history_ = *std::exchange(adoptedHistory_, std::nullopt);
            isTouched_ = !history_.steps().empty();  // in another window
        }
        history_.restart();
    }
    if (runner_ == nullptr) {
        fetched_.clear();
        log_.record(fetched_, {});
        return stepResult;
    }
    runner_->feed().fetchTicks(fetched_);
    log_.record(fetched_, followHistory());
    noteTouches();
    advanceHistory();
    if (runner_ == nullptr) return stepResult;
    stepResult.faultMessage = devices_.changedFault();
    reportOverload(stepResult);
    const Tick& newest = log_.newest();
    if (devices_.first() == nullptr) {
        surroundings_.show(manipulator_, *tooth_->piece, runner_->feed().surface(), bur_->instrument.shape);
    } else {  // it needs none of that but the depth
        advanceDepthControl();
    }
    manipulator_.advance(dt, newest.contact.proxy.position, newest.contact.depth);
    devices_.moveMouse(manipulator_.pose());
    runner_->setControls(currentControls());
    const MaterialVolumes ground = runner_->feed().loss().ground();
    instruments_.advanceGlass({.isInMouth = !tooth_->around.empty() && !isExamination_,
                               .sprayRuns = instruments_.water() && newest.input.cutting && newest.input.pedal > 0,
                               .ground = total(ground)},
                              dt);
    animation_.followPulp(log_.events(), *runner_->feed().surface(), haptics_.materials.registry());
    animation_.advance(newest, instruments_.water(), instruments_.suction(), ground, dt);
    return stepResult;
}

std::shared_ptr<const Surface> touchableSurface(const SessionModel& model) {
    return surrounded(model.runner()->feed().surface(), model.tooth()->piece->surroundings());
}

double handleX(const SessionModel& model) { return model.hand().leftHanded ? -model.mesialX() : model.mesialX(); }

}  // namespace tactooth

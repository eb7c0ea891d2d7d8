// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/workbench.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/common/spray_look.h"
#include "haptics/scene_load.h"
#include "session/audio/tick_sound.h"

namespace tactooth {
namespace {

const Box3 kNoTooth(Vec3(-5, -5, -5), Vec3(5, 5, 5));       // where the hand rests before there is a tooth, mm
constexpr float kBreath = 0.6F, kWetness = 0.5F;            // share of the glass, 0..1: one still sees the crown in it
constexpr double kEyeAzimuth = 1.25, kEyeElevation = 0.62;  // rad, for a tooth with +x mesial

}  // namespace

Workbench::Workbench(SoundOutput& sound) : sound_(sound), hand_(kNoTooth, 1), mouse_(hand_.hand()) {
    furniture_.start([] { return Expected<BenchFurniture>(makeFurniture()); });
}

Workbench::~Workbench() = default;

void Workbench::put(BenchTooth tooth) {
    tooth_ = std::move(tooth);
    takeHand();
    settings_.materials = tooth_->materials.value_or(MaterialTable());
    if (tooth_->bur) bur_ = tooth_->bur;
    simulatorIsOld_ = toothIsNew_ = true;
}

/// A fresh hand over the tooth, that presses as the one before.
void Workbench::takeHand() {
    const double pressDepth = hand_.pressDepth();
    hand_ = HandControl(tooth_ ? tooth_->box() : kNoTooth, handleX());
    hand_.setPressDepth(pressDepth);
}

void Workbench::put(BenchBur bur) {
    bur_ = std::move(bur);
    simulatorIsOld_ = true;
}

void Workbench::setSpindle(const SpindlePreset& spindle) {
    settings_.spindle = spindle;
    simulatorIsOld_ = true;
}

void Workbench::setRate(double rateHz) {
    if (rateHz == std::exchange(rate_, rateHz)) return;
    simulatorIsOld_ = true;
}

void Workbench::put(std::unique_ptr<HapticDevice> device) {
    simulator_.reset();  // it uses the old one
    device_ = std::move(device);
    simulatorIsOld_ = true;
}

void Workbench::useMouse() {
    simulator_.reset();  // it uses the device
    device_.reset();
    simulatorIsOld_ = true;
}

void Workbench::setLeftHanded(bool leftHanded) {
    if (leftHanded == std::exchange(leftHanded_, leftHanded)) return;
    takeHand();
    if (device_) simulatorIsOld_ = true;  // the hand takes the tool anew
}

void Workbench::setCutting(bool cutting) {
    const bool chosenByButton = newest_.cutting != controls.cutting;
    controls.cutting = cutting != (device_ && chosenByButton);
}

void Workbench::putSecond(std::unique_ptr<HapticDevice> device) {
    if (device == nullptr && second_ == nullptr) return;
    simulator_.reset();  // it may use an old one
    second_ = std::move(device);
    simulatorIsOld_ = true;
}

void Workbench::reportTrouble(News& news) {
    const char* trouble = device_ ? device_->trouble() : nullptr;
    if (trouble == nullptr && second_) trouble = second_->trouble();
    if (trouble != std::exchange(trouble_, trouble)) news.trouble = trouble;
    if (saidHeavy_ || !isSceneHeavy(simulator_->timing(), rate_)) return;
    saidHeavy_ = true;  // once for each tooth, bur and device
    news.heavyTick = slowTick(simulator_->timing());
}

void Workbench::takeDeliveries(News& news) {
    if (auto tooth = comingTooth_.poll()) {
        if (*tooth) {
            put(std::move(**tooth));
        } else {
            news.failure = tooth->error().message;
        }
    }
    if (auto bur = comingBur_.poll()) {
        if (*bur) {
            put(std::move(**bur));
        } else {
            news.failure = bur->error().message;
        }
    }
    if (auto furniture = furniture_.poll()) {
        around_ = std::move(**furniture);
        takeMirror(*around_, mirror_.diameter);
    }
}

/// From a device's frame into the tooth's: its "away" is the way that one looks at the tooth.
Quat Workbench::handTurn() const {
    return Quat(Eigen::AngleAxisd(usualView().azimuth + std::numbers::pi / 2, Vec3::UnitZ()));
}

/// All that a hand should reach with the tool.
Box3 Workbench::reached() const {
    const Vec3 around = Vec3::Constant(HandControl::kReach);
    return {tooth_->box().min() - around, tooth_->box().max() + around};
}

std::optional<Seat> Workbench::seat() const {
    if (!device_ || device_->info().isInTooth) return {};
    const std::optional<Vec3>& middle = device_->info().middle;
    if (!fits_ || !middle) return Seat{hand_.hand(), handTurn()};
    return Seat{{reached().center(), hand_.hand().rotation}, handTurn(), middle};
}

std::optional<WorkspaceFit> Workbench::fit() const {
    std::optional<WorkspaceFit> fit;
    if (!tooth_ || !device_) return fit;
    const Vec3 size = sizeAlongHand(reached().sizes(), handTurn());
    for (const HapticDevice* const device : {device_.get(), second_.get()}) {
        if (device == nullptr || device->info().workspace.isZero()) continue;
        const WorkspaceFit one = fitWorkspace(device->info().workspace, size);
        fit = fit ? WorkspaceFit{std::min(fit->fineness, one.fineness), fit->reachesAll && one.reachesAll} : one;
    }
    return fit;
}

double Workbench::fineness() const {
    if (!device_ || device_->info().isInTooth) return 1;
    return fits_ ? fit().value_or(WorkspaceFit()).fineness : controls.fineness;
}

void Workbench::startSimulator(News& news) {
    simulatorIsOld_ = false;
    hand_.release();
    mouse_.moveTo({hand_.hand(), 0, 0, true});
    simulator_.reset();  // its threads end before the new one's begin: they share the work piece and the device
    HapticDevice& device = device_ ? *device_ : mouse_;
    simulator_ = std::make_unique<Simulator>(
        tooth_->piece, bur_->instrument, settings_, device,
        [this, settings = settings_, edge = bur_->instrument.edge](const Tick& tick) {
            DrillSoundState heard = soundOf(tick, settings.spindle, settings.materials, edge);
            if (!water_) heard.water = 0;
            if (!suction_) heard.suction = 0;
            sound_.publish(heard);
        },
        rate_, seat(), second_.get(), fineness());
    saidHeavy_ = false;
    timeBefore_ += newest_.time;
    newest_ = Tick();
    newest_.cutting = controls.cutting;
    newest_.proxy = newest_.hand = hand_.hand();
    spray_ = SprayCloud(bur_->instrument.cutting.envelope.maxRadius(),
                        parkedSuction(tooth_->box(), tooth_->mesialX).position);
    news.newSimulator = true;
}

void Workbench::beginEvents() {
    events_ = {};
    timeBefore_ = -newest_.time;
}

void Workbench::resetTooth() {
    if (simulator_ == nullptr) return;
    simulator_->requestReset();
    beginEvents();
}

double Workbench::workSeconds() const {
    const std::vector<CutEvent>& events = events_.all();
    return events.empty() ? 0 : timeBefore_ + newest_.time - events.front().time;
}

void Workbench::watchTicks() {
    const ToothLoss loss = simulator_->loss();
    for (const Tick& tick : ticks_) events_.watch(timeBefore_ + tick.time, tick, loss);
}

Workbench::News Workbench::step(double dt) {
    News news;
    takeDeliveries(news);
    ticks_.clear();
    if (simulatorIsOld_ && tooth_ && bur_) {
        startSimulator(news);
        news.newTooth = std::exchange(toothIsNew_, false);
        if (news.newTooth) beginEvents();
    }
    if (simulator_ == nullptr) return news;
    simulator_->fetchTicks(ticks_);
    if (!ticks_.empty()) newest_ = ticks_.back();
    watchTicks();
    reportTrouble(news);
    hand_.advance(dt, newest_.proxy.position, newest_.depth);
    mouse_.moveTo({hand_.hand(), 0, 0, true});
    SimulatorControls now = controls;
    now.fineness = fineness();
    now.clutch = device_ && controls.clutch;
    simulator_->setControls(now);
    spin_ = std::remainder(spin_ + newest_.speedRpm / 60 * 2 * std::numbers::pi * dt, 2 * std::numbers::pi);
    spray(dt);
    return news;
}

void Workbench::setMirror(double diameter, bool fogged, bool wet) {
    const bool isAnother = diameter != mirror_.diameter;
    mirror_ = {diameter, fogged, wet};
    if (isAnother && around_) takeMirror(*around_, diameter);
}

void Workbench::spray(double dt) {
    spray_.advance({.toolInTooth = newest_.proxy,
                    .normal = newest_.normal,
                    .speedRpm = newest_.speedRpm,
                    .water = water_ && newest_.cutting ? newest_.pedal : 0,
                    .suction = suction_,
                    .ground = simulator_->loss().ground()},
                   dt);
}

std::shared_ptr<const Surface> Workbench::felt() const {
    return surrounded(simulator_->surface(), tooth_->piece->surroundings());
}

OrbitCamera::Direction Workbench::usualView() const {
    const OrbitCamera::Direction view{kEyeAzimuth, kEyeElevation};
    return mesialX() < 0 ? mirroredInX(view) : view;
}

SceneContents Workbench::contents(bool withTurbine, bool withMirror) const {
    SceneContents contents;
    contents.materials = settings_.materials;
    if (simulator_ == nullptr) return contents;
    contents.tooth = simulator_->surface();
    contents.around = tooth_->around;
    contents.tool = ShownTool{.bur = bur_->shown,
                              .turbine = withTurbine && around_ ? around_->turbine : nullptr,
                              .material = bur_->material,
                              .toolInTooth = newest_.proxy,
                              .spin = spin_,
                              .speedRpm = newest_.speedRpm,
                              .edge = bur_->instrument.edge,
                              .blurred = bur_->blurred};
    contents.flying = particlesOf(spray_.bits(), settings_.materials);
    if (around_) addSurroundings(contents, withMirror);
    return contents;
}

void Workbench::addSurroundings(SceneContents& contents, bool withMirror) const {
    if (suction_) contents.suction = ShownSuction{around_->suction, parkedSuction(tooth_->box(), tooth_->mesialX)};
    if (withMirror) {
        const auto [azimuth, elevation] = usualView();
        const Vec3 toEye(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
        Pose mirror = parkedMirror(tooth_->box(), around_->disc, toEye, handleX());
        const Pose& moved = simulator_->mirrorMotion();
        mirror = {mirror.position + moved.position, (moved.rotation * mirror.rotation).normalized()};
        contents.mirror = ShownMirror{.mesh = around_->mirror,
                                      .disc = around_->disc,
                                      .mirrorInTooth = mirror,
                                      .fog = mirror_.fogged ? kBreath : 0,
                                      .drops = mirror_.wet ? kWetness : 0};
    }
}

}  // namespace tactooth

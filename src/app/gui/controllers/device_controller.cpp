// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/device_controller.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/gui/controllers/window_messages.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "devices/open_device.h"
#include "session/scripts/replay_device.h"

namespace tactooth {
namespace {

constexpr const char* kMouse = "mouse";
constexpr const char* kNoDevice = "none";
constexpr std::string_view kGamepad = "gamepad";
constexpr double kButtonTime = 0.3;  // s until the drill bar follows a button of the device

/// The part of a gamepad's name that stands after the colon of `device`.
std::string padName(const std::string& device) {
    return device.size() > kGamepad.size() ? device.substr(kGamepad.size() + 1) : std::string();
}

}  // namespace

DeviceController::DeviceController(QMainWindow& window, SessionModel& model, const WindowPanels& panels,
                                   WindowMessages& messages)
    : model_(model),
      panels_(panels),
      messages_(messages),
      gamepad_(window, *panels.view),
      input_(window, *panels.drive, *panels.tour) {
    connect(panels_.device, &DevicePanel::deviceChosen, this, &DeviceController::openFirst);
    connect(panels_.device, &DevicePanel::secondDeviceChosen, this, &DeviceController::openSecond);
    connect(panels_.device, &DevicePanel::changed, this, &DeviceController::readSettings);
    connect(panels_.device, &DevicePanel::calibratingChanged, this, &DeviceController::setCalibrating);
    connect(&input_, &InputFilter::userActive, this, &DeviceController::userActive);
    readSettings();
}

void DeviceController::setCalibrating(bool calibrating) {
    if (calibrating == pedal_.isCalibrating()) return;
    if (const auto done = pedal_.setCalibrating(calibrating); !done) messages_.showError(done.error());
    panels_.device->setCalibrating(pedal_.isCalibrating());
    if (pedal_.isCalibrating()) {
        messages_.setHint(tr("Press the pedal fully, then let it go"));
    } else {
        emit usualHintDue();
    }
}

void DeviceController::readSettings() {
    const DeviceSettings settings = panels_.device->settings();
    const bool autoScaling = settings.motionScaling == kAutoScaling;
    if (!autoScaling) model_.controls.motionScaling = settings.motionScaling;
    model_.controls.buttons = panels_.device->buttons();
    model_.controls.clutch = panels_.device->clutch();
    const HandSettings before = model_.hand();
    model_.setHand({.rate = settings.rate, .leftHanded = settings.leftHanded, .autoScaling = autoScaling});
    if (settings.leftHanded != before.leftHanded || settings.rate != before.rate) {
        // An open device has been opened for the other hand or rate.
        if (model_.devices().second() != nullptr) openSecond(QString::fromStdString(settings.secondDevice));
        if (model_.devices().first() != nullptr) openFirst(QString::fromStdString(settings.device));
    }
    input_.setPedalKey(pedalKeyOf(settings));
}

void DeviceController::choosePedal(const DeviceSettings& settings) {
    const Expected<PedalBinding> pedal = parsePedal(settings.pedal);
    if (!pedal) {
        messages_.showError(pedal.error());
        panels_.device->showPedal({}, 0, 1);
    } else {
        PedalBinding choice = *pedal;
        choice.up = settings.pedalUp;
        choice.down = settings.pedalDown;
        const auto done = pedal_.choose(choice);
        if (!done) messages_.showError(done.error());
    }
}

void DeviceController::change(const DeviceSettings& settings) {
    const DeviceSettings before = this->settings();
    if (settings == before) return;
    panels_.device->set(settings);
    const bool isOtherPedal =
        settings.pedal != before.pedal || settings.pedalUp != before.pedalUp || settings.pedalDown != before.pedalDown;
    if (isOtherPedal) choosePedal(settings);
    if (settings.device != before.device) openFirst(QString::fromStdString(settings.device));
    if (settings.secondDevice != before.secondDevice) openSecond(QString::fromStdString(settings.secondDevice));
}

void DeviceController::apply(const DeviceSettings& settings) {
    panels_.device->set(settings);
    choosePedal(settings);
    first_ = settings.device;
    second_ = settings.secondDevice;
    openFirst(QString::fromStdString(settings.device));
    openSecond(QString::fromStdString(settings.secondDevice));
}

DeviceSettings DeviceController::settings() const {
    DeviceSettings settings = panels_.device->settings();
    settings.device = first_;
    settings.secondDevice = second_;
    return settings;
}

void DeviceController::openFirst(const QString& name) {
    panels_.device->showDevice(name);
    pendingFirst_.cancel();
    model_.install(DeviceSlot::First, nullptr);
    if (name == kMouse) {
        first_ = kMouse;
        return;
    }
    messages_.setHint(tr("Opening the device…"));
    pendingFirst_.start([wanted = name.toStdString(), hand = model_.hand()] {
        return openDeviceOrReplay(wanted, hand.leftHanded, hand.rate);
    });
}

void DeviceController::openSecond(const QString& name) {
    panels_.device->showSecondDevice(name);
    pendingSecond_.cancel();
    model_.install(DeviceSlot::Second, nullptr);
    if (name.isEmpty() || name == kNoDevice) {
        second_ = kNoDevice;
        return;
    }
    pendingSecond_.start([wanted = name.toStdString(), hand = model_.hand()] {
        return openDeviceOrReplay(wanted, hand.leftHanded, hand.rate);
    });
}

void DeviceController::collect() {
    if (auto device = pendingFirst_.poll()) {
        if (*device) {
            model_.install(DeviceSlot::First, std::move(**device));
            first_ = panels_.device->settings().device;
            if (isReplay(first_)) first_ = kMouse;  // a trajectory is replayed once, not at each start
            emit usualHintDue();
        } else {
            panels_.device->showDevice(kMouse);
            messages_.showError(device->error());
        }
    }
    if (auto second = pendingSecond_.poll()) {
        if (*second) {
            model_.install(DeviceSlot::Second, std::move(**second));
            second_ = panels_.device->settings().secondDevice;
        } else {
            panels_.device->showSecondDevice(kNoDevice);
            messages_.showError(second->error());
        }
    }
}

/// The foot pedal, the pedal key and the slider: the one that is furthest down counts.
void DeviceController::stepPedal() {
    const bool wasCalibrating = pedal_.isCalibrating();
    const double foot = pedal_.step();
    if (wasCalibrating && !pedal_.isCalibrating()) {
        const PedalBinding& taught = pedal_.choice();
        panels_.device->showPedal(pedalText(taught), taught.up, taught.down);
        panels_.device->setCalibrating(false);
        messages_.setHint(tr("The pedal is %1").arg(QString::fromStdString(pedalText(taught))));
    }
    model_.controls.pedal = std::max(foot, panels_.drive->pedal());
}

bool DeviceController::usesGamepad() const {
    return model_.devices().first() != nullptr && first_.starts_with(kGamepad);
}

void DeviceController::stepGamepad(double dt) {
    const bool wasInPanels = gamepad_.isInPanels();
    gamepad_.setGamepad(usesGamepad() ? std::optional(padName(first_)) : std::nullopt);
    if (gamepad_.step(dt)) emit userActive();
    model_.devices().suspendInput(gamepad_.capturesInput());
    if (wasInPanels != gamepad_.isInPanels()) emit usualHintDue();
}

void DeviceController::step(double dt) {
    stepPedal();
    collect();
    stepGamepad(dt);
}

/// A choice of the bar itself needs some ticks to arrive.
void DeviceController::followButtons() {
    const Tick& newest = model_.log().newest();
    const bool agrees = newest.input.cutting == panels_.drill->isCutting();
    if (agrees || model_.devices().first() == nullptr || model_.log().ticks().empty()) {
        disagreesSince_ = newest.time;
    } else if (newest.time > disagreesSince_ + kButtonTime) {
        panels_.drill->showCutting(newest.input.cutting);
    }
}

void DeviceController::showState() {
    const LiveRunner* runner = model_.runner();
    const ForceState force = runner != nullptr ? runner->feed().forceState() : ForceState::Off;
    const auto nameOf = [](const HapticDevice* device) {
        return device != nullptr ? QString::fromStdString(device->info().name) : QString();
    };
    const auto faultOf = [](const HapticDevice* device) {
        return device != nullptr ? device->faultMessage() : nullptr;
    };
    const HapticDevice* first = model_.devices().first();
    const HapticDevice* second = model_.devices().second();
    panels_.device->showState(nameOf(first), force, faultOf(first));
    panels_.device->showSecondState(nameOf(second), faultOf(second));
    panels_.device->showFit(model_.fit());
}

}  // namespace tactooth

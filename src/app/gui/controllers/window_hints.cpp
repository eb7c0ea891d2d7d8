// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/window_hints.h"

#include <utility>

#include "app/gui/controllers/device_controller.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"

namespace tactooth {

WindowHints::WindowHints(SessionModel& model, const WindowPanels& panels, const DeviceController& devices,
                         WindowMessages& messages)
    : model_(model), panels_(panels), devices_(devices), messages_(messages) {
    connect(&devices_, &DeviceController::usualHintDue, this, &WindowHints::showUsual);
    connect(panels_.drive, &DrivePanel::pedalChanged, this, &WindowHints::showPedal);
    connect(panels_.inspection->ghostAction(), &QAction::toggled, this, &WindowHints::showGhost);
    connect(panels_.tour, &GuidedTour::stepExplained, this,
            [this](const QString& sentence) { messages_.setHint(sentence); });
    connect(panels_.view, &ToothView::mirrorNotPlaced, this, [this] {
        messages_.setHint(
            tr("No place of the mirror shows the bur from behind: turn the tooth, or move the mirror by the mouse"));
    });
    connect(panels_.view, &ToothView::dentistViewTaken, this, [this](int clock, bool byMirror) {
        messages_.setHint(byMirror ? tr("As from %1 o'clock, with the mirror held to the chewing surface").arg(clock)
                                   : tr("As from %1 o'clock, without the mirror").arg(clock));
    });
    connect(panels_.tour, &GuidedTour::ended, this, &WindowHints::showUsual);
}

QString WindowHints::pedalKey() const { return nativeText(QKeySequence(devices_.pedalKey())); }

void WindowHints::showUsual() {
    if (fault_) {
        messages_.setHint(translated(*fault_));
    } else if (model_.devices().first() == nullptr && holdsHandInstrument()) {
        messages_.setHint(tr("Left button: press the instrument on the tooth · wheel: how hard · right: turn"));
    } else if (model_.devices().first() == nullptr) {
        messages_.setHint(
            tr("Left button: press the bur on the tooth · wheel: how deep · right: turn · %1: pedal").arg(pedalKey()));
    } else if (devices_.isGamepadInPanels()) {
        messages_.setHint(tr("D-pad: control and value · shoulders: panel · A: press · B: back to the tooth"));
    } else if (devices_.usesGamepad()) {
        messages_.setHint(
            tr("Left stick: move · left trigger: press · left shoulder: lift · right stick: lean · right trigger: "
               "pedal · A: touch or cut · d-pad: turn · Start: menus · Back: panels"));
    } else {
        messages_.setHint(
            tr("Move the device: the bur follows it · %1: pedal · %2: cut, %3: touch")
                .arg(pedalKey(), keyOf(*panels_.drill->cutAction()), keyOf(*panels_.drill->touchAction())));
    }
}

/// A hint, not a message: a message would take the keys and the pedal from the user at work.
void WindowHints::showFault(const Message* fault) {
    fault_ = fault != nullptr ? std::optional(*fault) : std::nullopt;
    shown_ = Reason::None;
    showUsual();
    if (!fault_ && overload_) showOverload(*std::exchange(overload_, std::nullopt));
}

void WindowHints::showOverload(double microseconds) {
    if (fault_) {
        overload_ = microseconds;
        return;
    }
    messages_.setHint(
        tr("The scene is heavy for this machine: one tick in a hundred takes %1 of the %2 µs that there are; "
           "take a tooth of fewer triangles ('tactooth simplify') or a bur of fewer triangles, and close "
           "other programs.")
            .arg(microseconds, 0, 'f', 0)
            .arg(1e6 / model_.hand().rate, 0, 'f', 0));
}

bool WindowHints::holdsHandInstrument() const { return model_.bur() && model_.bur()->isHandInstrument(); }

void WindowHints::showPedal(double pedal) {
    if (pedal == 0 || fault_) return;
    if (holdsHandInstrument()) {
        return messages_.setHint(tr("An instrument in the hand has no drive: take a handpiece from the tray first"));
    }
    if (panels_.drill->isCutting()) return;
    messages_.setHint(tr("In Touch the bur stands still: choose Cut (%1), and the pedal turns it")
                          .arg(keyOf(*panels_.drill->cutAction())));
}

void WindowHints::showGhost(bool on) {
    if (!on || fault_) return showUsual();
    messages_.setHint(
        tr("Blue glass: still to cut, darker where deeper. Dark line: the outline, dashed where the tooth "
           "hides it."));
}

WindowHints::Reason WindowHints::reason() const {
    const HapticDevice* device = model_.devices().first();
    const LiveRunner* runner = model_.runner();
    if (runner == nullptr || panels_.tour->isRunning()) return Reason::None;
    const Tick& tick = model_.log().newest();
    if (device != nullptr) {
        if (device->faultMessage() != nullptr) return Reason::None;  // showUsual says it
        if (runner->feed().forceState() == ForceState::AwaitsFreeSpace && tick.contact.triangles > 0)
            return Reason::ForceWaits;
        if (runner->feed().isDeviceAtWorkspaceLimit()) return Reason::WorkspaceEnd;
    }
    const bool presses = device != nullptr || model_.manipulator().isPressing();  // a bur may rest in its cavity
    if (tick.contact.triangles == 0 || !presses) return Reason::None;
    if (tick.input.cutting) return tick.input.pedal == 0 ? Reason::BurStopped : Reason::None;
    return tick.input.pedal > 0 ? Reason::OnlyTouches : Reason::None;
}

QString WindowHints::text(Reason reason) const {
    switch (reason) {
        case Reason::ForceWaits:
            return forceStateText(ForceState::AwaitsFreeSpace);
        case Reason::WorkspaceEnd:
            return tr("The hand is at the end of the device's workspace: hold the bur (%1), bring the hand back and "
                      "let go")
                .arg(keyOf(*panels_.device->clutchAction()));
        case Reason::BurStopped:
            return tr("The bur stands still: hold the pedal (%1), or tick Keep down").arg(pedalKey());
        case Reason::OnlyTouches:
            return tr("The bur only touches: choose Cut (%1) to remove something")
                .arg(keyOf(*panels_.drill->cutAction()));
        case Reason::None:
            break;
    }
    return {};
}

void WindowHints::update() {
    const Reason now = reason();
    if (now == std::exchange(shown_, now)) return;
    if (now == Reason::None) return showUsual();
    messages_.setHint(text(now));
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/instrument_controller.h"

#include <utility>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/instrument_tray.h"

namespace tactooth {

InstrumentController::InstrumentController(SessionModel& model, const WindowPanels& panels)
    : model_(model), panels_(panels) {
    connect(panels_.tray, &InstrumentTray::handpieceChosen, this, &InstrumentController::takeHandpiece);
    connect(panels_.tray, &InstrumentTray::handInstrumentChosen, this, &InstrumentController::takeHandInstrument);
    connect(panels_.drill, &DrillBar::spindleChosen, this,
            [this] { panels_.tray->show(shown_, panels_.drill->spindleName()); });
}

/// The handpiece comes back with the bur that it had.
void InstrumentController::takeHandpiece(const SpindlePreset& drive) {
    const QString name = QString::fromStdString(drive.name);
    if (name != panels_.drill->spindleName()) panels_.drill->choose({}, name);
    if (!model_.bur() || !model_.bur()->isHandInstrument()) return;
    if (bur_) {
        model_.install(*bur_);
    } else {
        panels_.drill->takeBur(panels_.drill->currentBur());  // the window began with a hand instrument
    }
}

void InstrumentController::takeHandInstrument(HandInstrument kind) {
    if (model_.bur() && model_.bur()->instrument.hand == kind) return;
    model_.install(makeHandInstrument(kind));
}

void InstrumentController::takeRunner() {
    const SessionBur& now = *model_.bur();
    if (!now.isHandInstrument()) bur_ = now;
    panels_.tray->show(now.instrument.hand, panels_.drill->spindleName());
    if (std::exchange(shown_, now.instrument.hand) != now.instrument.hand) emit changed();
}

void InstrumentController::poll() {
    const std::optional<InstrumentMeshes>& meshes = model_.instruments().meshes();
    if (meshes && !std::exchange(hasHandpieces_, true)) panels_.tray->setHandpieces(meshes->handpieces);
}

}  // namespace tactooth

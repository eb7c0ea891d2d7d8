// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/panel_updater.h"

#include <QProgressBar>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/panels/timing_panel.h"
#include "app/gui/scene/tooth_view.h"
#include "session/model/session_model.h"

namespace tactooth {

PanelUpdater::PanelUpdater(SessionModel& model, const WindowPanels& panels, const SoundOutput& sound)
    : model_(model), panels_(panels), sound_(sound) {}

void PanelUpdater::showStep(bool busy) {
    if (model_.runner() != nullptr) trace_.setUncut(model_.runner()->feed().surface()->base);
    trace_.add(model_.log().ticks());
    panels_.busy->setVisible(busy);
    if (replaying_) return;
    if (model_.tooth()) {
        panels_.inspection->followBur(model_.log().newest().contact.proxy.position, model_.tooth()->box(),
                                      model_.mesialX());
    }
    panels_.view->refresh();
}

void PanelUpdater::restart() {
    trace_.clear();
    panels_.timing->reset();
    if (model_.bur()->isHandInstrument()) return;  // the bar keeps the bur that waits in the handpiece
    panels_.drill->show(QString::fromStdString(model_.bur()->name),
                        QString::fromStdString(model_.bur()->file.string()));
}

void PanelUpdater::showNumbers() {
    if (replaying_) return;
    panels_.drive->show(model_.log().newest());
    panels_.plots->show(trace_);
    panels_.events->show(model_.log().events().all());
}

void PanelUpdater::showStatus() {
    if (model_.runner() == nullptr) return;
    panels_.status->show(*model_.runner(), sound_.status());
    if (!isInSight(*panels_.timing)) return;
    const HapticDevice* device = model_.devices().first();
    panels_.timing->show(*model_.runner(), panels_.view->pictureTimes().counts(),
                         device != nullptr ? QString::fromStdString(device->info().name) : tr("mouse"),
                         model_.hand().rate);
}

bool isInSight(const QWidget& panel) { return !panel.visibleRegion().isEmpty(); }

}  // namespace tactooth

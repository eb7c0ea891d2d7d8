// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/record_exports.h"

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/plot_export.h"
#include "app/gui/panels/plot_panel.h"
#include "geometry/files/atomic_file.h"
#include "session/model/session_model.h"

namespace tactooth {

RecordExports::RecordExports(SessionModel& model, const WindowPanels& panels, WindowMessages& messages,
                             FileDialogs& files)
    : model_(model), panels_(panels), messages_(messages), files_(files) {
    connect(panels_.plots, &PlotPanel::exportRequested, this, &RecordExports::askForPlotFile);
    connect(panels_.events, &EventPanel::exportRequested, this, &RecordExports::askForEventFile);
}

void RecordExports::askForPlotFile() {
    files_.save(tr("Export plots: a table or a picture"), tr("Table (*.csv);;Picture (*.png);;Drawing (*.svg)"),
                "plots.csv", [this](const QString& file) { exportPlotsTo(file); });
}

void RecordExports::exportPlotsTo(const QString& file) {
    files_.enterFolderOf(file);
    const Expected<void> written = exportPlots(panels_.plots->shown(), panels_.plots->plots(), file.toStdString());
    if (!written) return messages_.showError(written.error());
    messages_.setHint(tr("The plots were written to %1").arg(file));
}

void RecordExports::askForEventFile() {
    files_.save(tr("Export what happened"), tr("Table (*.csv)"), "events.csv",
                [this](const QString& file) { exportEventsTo(file); });
}

void RecordExports::exportEventsTo(const QString& file) {
    files_.enterFolderOf(file);
    const Expected<void> written = writeFile(file.toStdString(), cutEventsCsv(model_.log().events().all()));
    if (!written) return messages_.showError(written.error());
    messages_.setHint(tr("The list was written to %1").arg(file));
}

}  // namespace tactooth

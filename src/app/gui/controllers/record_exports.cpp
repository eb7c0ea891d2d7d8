// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/record_exports.h"

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/plot_export.h"
#include "app/gui/panels/plot_panel.h"
#include "geometry/util/byte_text.h"
#include "session/model/file_writer.h"
#include "session/model/session_model.h"

namespace tactooth {

RecordExports::RecordExports(SessionModel& model, const WindowPanels& panels, WindowMessages& messages,
                             FileDialogs& files, FileWriter& writer)
    : model_(model), panels_(panels), messages_(messages), files_(files), writer_(writer) {
    connect(panels_.plots, &PlotPanel::exportRequested, this, &RecordExports::askForPlotFile);
    connect(panels_.events, &EventPanel::exportRequested, this, &RecordExports::askForEventFile);
}

void RecordExports::askForPlotFile() {
    files_.save(tr("Export plots: a table or a picture"), tr("Table (*.csv);;Picture (*.png);;Drawing (*.svg)"),
                "plots.csv", [this](const QString& file) { exportPlotsTo(file); });
}

void RecordExports::exportPlotsTo(const QString& file) {
    files_.enterFolderOf(file);
    writer_.write(plotsExport(panels_.plots->shown(), panels_.plots->plots(), file.toStdString()),
                  [this, file](const Expected<bool>& written) {
                      messages_.showWritten(written, tr("The plots were written to %1").arg(file));
                  });
}

void RecordExports::askForEventFile() {
    files_.save(tr("Export what happened"), tr("Table (*.csv)"), "events.csv",
                [this](const QString& file) { exportEventsTo(file); });
}

void RecordExports::exportEventsTo(const QString& file) {
    files_.enterFolderOf(file);
    writer_.write(
        [events = model_.log().events().all(), path = file.toStdString()](const GoesOn& goesOn) {
            const std::string table = cutEventsCsv(events);
            return writeInPieces(path, asBytes(table), goesOn);
        },
        [this, file](const Expected<bool>& written) {
            messages_.showWritten(written, tr("The list was written to %1").arg(file));
        });
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/gui/controllers/window_panels.h"

namespace tactooth {

class FileDialogs;
class FileWriter;
class SessionModel;
class WindowMessages;

/// Writes the plots and the list of events to files, in the background.
class RecordExports final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the exports.
    RecordExports(SessionModel& model, const WindowPanels& panels, WindowMessages& messages, FileDialogs& files,
                  FileWriter& writer);

    /// As a table or a picture, see exportPlots; shows a message if that fails.
    void exportPlotsTo(const QString& file);
    /// As a table; shows a message if that fails.
    void exportEventsTo(const QString& file);

private:
    void askForPlotFile();
    void askForEventFile();

    SessionModel& model_;
    WindowPanels panels_;
    WindowMessages& messages_;
    FileDialogs& files_;
    FileWriter& writer_;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <vector>

#include "app/gui/dialogs/scan_importer.h"
#include "session/model/session_loader.h"

namespace tactooth {

class FileDialogs;
class WindowMessages;

/// Brings teeth and burs into the session and writes the tooth to files.
class ToothController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller; `window` is the parent of its dialogs.
    ToothController(SessionModel& model, WindowMessages& messages, FileDialogs& files, QWidget& window);

    void loadBuiltinTooth(const BuiltinToothEntry& entry);
    /// A tooth among its neighbours and gums.
    void loadMouth(const MouthChoice& mouth);
    /// `hint`: what the status line says meanwhile.
    void load(Task<SessionTooth>::Function tooth, const QString& hint);
    void openTooth(const ToothSource& source, const std::string& workOn = {});
    /// A tooth, a case, the description of an exercise, or a recorded session.
    void openFile(const QString& file);
    /// Another tooth of the case that is open.
    void openToothOfCase(const std::string& name) { openTooth(source_, name); }
    /// Opens teeth, cases, exercises and recordings; shows the import dialog for surfaces.
    void openDropped(const std::vector<std::filesystem::path>& files);
    /// Surfaces of one tooth in any unit and position. A dialog shows what is assumed before the import.
    void importScan(const std::vector<std::filesystem::path>& files);
    void loadBur(const BurSpec& spec);
    void openBur(const QString& file);
    /// Writes the surface of the tooth as it is now; shows a message if that fails.
    void exportTooth(const QString& file);
    /// Saves the tooth with its layers and all cuts, to go on later; shows a message if that fails.
    void saveTooth(const QString& file);

    void askForTooth();
    void askForScan();
    void askForBur();
    void askForExport();
    void askForSave();

    /// Takes over what is ready. Call it before each step of the model.
    void poll();
    [[nodiscard]] bool isBusy() const { return loader_.isBusy(); }
    [[nodiscard]] bool isImporting() const { return importer_.isBusy(); }
    /// The files of the tooth that was opened last.
    [[nodiscard]] const ToothSource& source() const { return source_; }
    void setSource(ToothSource source) { source_ = std::move(source); }

signals:
    void fileOpened(const QString& file);
    void exerciseFileChosen(const QString& file);
    void recordingChosen(const QString& file);
    void loadingFailed();

private:
    [[nodiscard]] bool isReplaying() const;

    SessionModel& model_;
    WindowMessages& messages_;
    FileDialogs& files_;
    QWidget& window_;
    SessionLoader loader_;
    ScanImporter importer_;
    ToothSource source_;
};

}  // namespace tactooth

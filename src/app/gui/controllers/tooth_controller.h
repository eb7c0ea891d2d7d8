// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/dialogs/case_maker.h"
#include "app/gui/dialogs/scan_importer.h"
#include "app/gui/model/long_work.h"
#include "session/model/session_loader.h"

namespace tactooth {

class ExaminationMode;
class FileDialogs;
class FileWriter;
class UnsavedWork;
class WindowMessages;

/// Brings teeth and burs into the session and writes the tooth to files. Each tooth that comes replaces another one, so
/// all of them pass UnsavedWork::confirmDiscard.
class ToothController final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller; `window` is the parent of its dialogs.
    ToothController(SessionModel& model, const ExaminationMode& mode, WindowMessages& messages, FileDialogs& files,
                    FileWriter& writer, UnsavedWork& unsaved, QWidget& window);

    void loadBuiltinTooth(const BuiltinToothEntry& entry);
    /// A tooth among its neighbours and gums.
    void loadMouth(const MouthChoice& mouth);
    /// The share of the work that is done, 0..1; null: nobody knows.
    using LoadedShare = std::shared_ptr<const std::atomic<double>>;
    /// `hint`: what the status line says meanwhile.
    void load(Task<SessionTooth>::Function tooth, const QString& hint, LoadedShare share = nullptr);
    /// Makes a tooth in the background, and reports how much of it is done.
    using MakeTooth = std::function<Expected<SessionTooth>(const ShareDone& progress)>;
    void make(const MakeTooth& tooth, const QString& hint);
    void openTooth(const ToothSource& source, const std::string& workOn = {});
    /// A tooth, a case, the description of an exercise, a recorded session, or a scan to import, as RecentFile::text.
    void openFile(const QString& file);
    /// Another tooth of the case that is open.
    void openToothOfCase(const std::string& name) { openTooth(source_, name); }
    /// Opens teeth, cases, exercises and recordings; shows the import dialog for surfaces.
    void openDropped(const std::vector<std::filesystem::path>& files);
    /// Surfaces of one tooth in any unit and position. A dialog shows what is assumed before the import.
    void importScan(const std::vector<std::filesystem::path>& files);
    /// Makes a case of all teeth of a folder, and opens it; a folder that is a case is opened.
    void importFolder(const std::filesystem::path& folder);
    void loadBur(const BurSpec& spec);
    void openBur(const QString& file);
    /// Writes the surface of the tooth as it is now, in the background; shows a message if that fails.
    void exportTooth(const QString& file);
    /// Saves the tooth as it is now with its layers, all cuts and what was being done with it, to go on later. The file
    /// is written in the background. Shows a message if that fails. `saved`: called when the tooth was saved.
    void saveTooth(const QString& file, const std::function<void()>& saved = {});

    void askForTooth();
    void askForScan();
    void askForScanFolder();
    void askForBur();
    void askForExport();
    /// `saved`: called when the tooth was saved.
    void askForSave(const std::function<void()>& saved = {});

    /// Takes over what is ready. Call it before each step of the model.
    void poll();
    [[nodiscard]] bool isBusy() const { return loader_.isBusy(); }
    /// A tooth or a bur that is being loaded. It can be cancelled if there is a tooth to go back to.
    [[nodiscard]] std::optional<LongWork> loading();
    [[nodiscard]] bool isImporting() const { return importer_.isBusy() || caseMaker_.isBusy(); }
    /// The files of the tooth that was opened last.
    [[nodiscard]] const ToothSource& source() const { return source_; }
    void setSource(ToothSource source) { source_ = std::move(source); }
    /// Returns what the user is doing, for a saved tooth.
    void setWork(std::function<SessionWork()> work) { work_ = std::move(work); }
    /// Returns whether a recording is shown in place of the tooth.
    void setShowsRecording(std::function<bool()> shows) { showsRecording_ = std::move(shows); }
    /// Files that the user has opened before: a saved tooth may need one of them.
    void setKnownFiles(std::vector<std::filesystem::path> files) { knownFiles_ = std::move(files); }
    [[nodiscard]] const std::vector<std::filesystem::path>& knownFiles() const { return knownFiles_; }

signals:
    /// `file`: as RecentFile::text.
    void fileOpened(const QString& file);
    void toothSaved(const QString& file);
    void exerciseFileChosen(const QString& file);
    void recordingChosen(const QString& file);
    /// The second is compared with the first.
    void twoRecordingsChosen(const QString& first, const QString& second);
    void loadingFailed();
    /// The tooth stays: the user keeps its cuts, which are not saved, an examination goes on with it, or the user has
    /// cancelled what was being loaded.
    void loadingDeclined();

private:
    void cancelLoading();
    void replaceTooth(const std::function<void()>& load);
    void install(const SessionTooth& imported, const RecentFile& from);
    void markSaved(const std::shared_ptr<CutModel>& piece, const MaterialVolumes& removed);
    [[nodiscard]] bool isReplaying() const;

    SessionModel& model_;
    const ExaminationMode& mode_;
    WindowMessages& messages_;
    FileDialogs& files_;
    FileWriter& writer_;
    UnsavedWork& unsaved_;
    QWidget& window_;
    SessionLoader loader_;
    LoadedShare share_;
    ScanImporter importer_;
    CaseMaker caseMaker_;
    ToothSource source_;
    std::function<SessionWork()> work_;
    std::function<bool()> showsRecording_;
    std::vector<std::filesystem::path> knownFiles_;
    MaterialVolumes importedAt_{};  // what was gone when the user agreed to import
};

}  // namespace tactooth

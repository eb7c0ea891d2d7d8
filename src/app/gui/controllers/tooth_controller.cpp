// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/tooth_controller.h"

#include <QFileInfo>
#include <utility>

#include "app/gui/controllers/file_dialogs.h"
#include "app/gui/controllers/unsaved_work.h"
#include "app/gui/controllers/window_messages.h"
#include "app/gui/dialogs/open_tooth_dialog.h"
#include "app/gui/model/current_work.h"
#include "app/gui/model/examination_mode.h"
#include "app/gui/text/translation.h"
#include "geometry/files/atomic_file.h"
#include "geometry/io/stl_writer.h"
#include "session/cases/case_store.h"
#include "session/recording/session_recorder.h"

namespace tactooth {
namespace {

bool isRecording(const std::filesystem::path& file) { return file.extension() == kSessionFileEnding; }

}  // namespace

namespace {

MaterialVolumes removedNow(const SessionModel& model) {
    if (model.runner() != nullptr) return model.runner()->feed().removed();
    return model.tooth() ? model.tooth()->piece->removed() : MaterialVolumes{};
}

/// The session stands still, and no thread works on the tooth.
bool isStill(const SessionModel& model) { return model.tooth() && model.isPaused(); }

}  // namespace

ToothController::ToothController(SessionModel& model, const ExaminationMode& mode, WindowMessages& messages,
                                 FileDialogs& files, UnsavedWork& unsaved, QWidget& window)
    : model_(model),
      mode_(mode),
      messages_(messages),
      files_(files),
      unsaved_(unsaved),
      window_(window),
      loader_(model) {
    unsaved_.setSaver([this](const std::function<void()>& saved) { askForSave(saved); });
    connect(&importer_, &ScanImporter::failed, this,
            [this](const QString& sentence) { messages_.showError(sentence); });
    connect(&importer_, &ScanImporter::imported, this, [this](const SessionTooth& tooth, const RecentFile& from) {
        if (mode_.allowsAnotherTooth() && removedNow(model_) == importedAt_) return install(tooth, from);
        replaceTooth([this, tooth, from] { install(tooth, from); });  // something was cut meanwhile
    });
    connect(&caseMaker_, &CaseMaker::failed, this, [this](const QString& sentence) { messages_.showError(sentence); });
    connect(&caseMaker_, &CaseMaker::written, this, &ToothController::openFile);
    connect(&caseMaker_, &CaseMaker::fileWanted, this, [this](const QString& proposed) {
        files_.save(tr("Save the case"), tr("Cases (*.ttcase)"), proposed,
                    [this](const QString& file) { caseMaker_.write(file); });
    });
}

void ToothController::install(const SessionTooth& imported, const RecentFile& from) {
    emit fileOpened(from.text());
    messages_.setHint(tr("%1 was imported").arg(QString::fromStdString(imported.name)));
    model_.install(imported);
}

void ToothController::replaceTooth(const std::function<void()>& load) {
    if (!mode_.allowsAnotherTooth()) {
        messages_.setHint(tr("The examination has begun with this tooth: finish it before you take another one"));
        emit loadingDeclined();
        return;
    }
    unsaved_.confirmDiscard(load, [this] { emit loadingDeclined(); });
}

void ToothController::load(Task<SessionTooth>::Function tooth, const QString& hint, LoadedShare share) {
    replaceTooth([this, tooth = std::move(tooth), hint, share = std::move(share)] {
        messages_.setHint(hint);
        share_ = share;
        loader_.load(tooth);
    });
}

std::optional<double> ToothController::loadedShare() const {
    return isBusy() && share_ ? std::optional(share_->load()) : std::nullopt;
}

void ToothController::cancelLoading() {
    loader_.cancel();
    messages_.setHint(tr("Loading was cancelled: the tooth stays as it is"));
    emit loadingDeclined();
}

void ToothController::loadBuiltinTooth(const BuiltinToothEntry& entry) {
    load([entry] { return makeSessionTooth(entry); }, tr("Making the tooth: %1…").arg(translated(entry.name)));
}

void ToothController::loadMouth(const MouthChoice& mouth) {
    const auto share = std::make_shared<std::atomic<double>>(0);
    const auto make = [mouth, share] {
        // The parts are counted by several threads: the largest count is the newest.
        return makeSessionTooth(mouth, [&](double done) {
            double before = share->load();
            while (before < done && !share->compare_exchange_weak(before, done)) {
            }
        });
    };
    load(make, tr("Making the whole mouth around tooth %1…").arg(mouth.fdi), share);
}

void ToothController::openTooth(const ToothSource& source, const std::string& workOn) {
    replaceTooth([this, source, workOn] {
        const QString file = QString::fromStdString(source.outer.string());
        files_.enterFolderOf(file);
        emit fileOpened(file);
        source_ = source;
        messages_.setHint(tr("Opening %1…").arg(QString::fromStdString(source.outer.filename().string())));
        share_.reset();
        loader_.load(Task<SessionTooth>::Function(
            [source, workOn, known = knownFiles_] { return openSessionTooth(source, workOn, known); }));
    });
}

void ToothController::openFile(const QString& file) {
    if (const RecentFile recent = RecentFile::fromText(file); recent.isScan) {
        std::vector<std::filesystem::path> surfaces;
        for (const QString& surface : recent.files) surfaces.emplace_back(surface.toStdString());
        importScan(surfaces);
    } else if (isRecording(file.toStdString())) {
        emit fileOpened(file);
        emit recordingChosen(file);
    } else if (QFileInfo(file).suffix() == "toml") {
        emit exerciseFileChosen(file);
    } else {
        openTooth({.outer = file.toStdString(), .layers = {}});
    }
}

void ToothController::openDropped(const std::vector<std::filesystem::path>& files) {
    if (files.size() == 2 && isRecording(files[0]) && isRecording(files[1])) {
        emit twoRecordingsChosen(QString::fromStdString(files[0].string()), QString::fromStdString(files[1].string()));
    } else if (isCase(files.front()) || isToothFile(files.front()) || isRecording(files.front()) ||
               files.front().extension() == ".toml") {
        openFile(QString::fromStdString(files.front().string()));
    } else if (std::error_code unreadable; std::filesystem::is_directory(files.front(), unreadable)) {
        importFolder(files.front());
    } else {
        importScan(files);
    }
}

void ToothController::importScan(const std::vector<std::filesystem::path>& files) {
    replaceTooth([this, files] {
        files_.enterFolderOf(QString::fromStdString(files.front().string()));
        importedAt_ = removedNow(model_);
        importer_.begin(files, &window_);
    });
}

void ToothController::importFolder(const std::filesystem::path& folder) {
    const QString name = QString::fromStdString(folder.string());
    if (isCase(folder)) return openFile(name);
    files_.enterFolderOf(name);
    caseMaker_.begin({folder}, &window_);
}

void ToothController::loadBur(const BurSpec& spec) {
    loader_.load(Task<SessionBur>::Function([spec] { return makeSessionBur(spec); }));
}

void ToothController::openBur(const QString& file) {
    files_.enterFolderOf(file);
    loader_.load(Task<SessionBur>::Function([path = file.toStdString()] { return loadSessionBur(path); }));
}

void ToothController::exportTooth(const QString& file) {
    if (model_.runner() == nullptr && !isStill(model_)) return;
    files_.enterFolderOf(file);
    const MaterialVolumes removed = removedNow(model_);
    const TaggedMesh surface =
        model_.runner() != nullptr ? model_.runner()->feed().exported() : model_.tooth()->piece->exported();
    const Expected<void> written = writeStl(surface.mesh, file.toStdString());
    if (!written) return messages_.showError(written.error());
    model_.markSaved(removed);
    messages_.setHint(tr("The tooth was written to %1").arg(file));
}

bool ToothController::saveTooth(const QString& file) {
    if (model_.runner() == nullptr && !isStill(model_)) return false;
    files_.enterFolderOf(file);
    const MaterialVolumes removed = removedNow(model_);
    const std::string work = work_ ? workTextWithoutFolders(work_()) : std::string();
    const Provenance provenance = savedNow(model_.tooth()->provenance);
    const auto bytes = model_.runner() != nullptr ? model_.runner()->toothFile(provenance, work)
                                                  : toothFileBytes(*model_.tooth()->piece, provenance, work);
    const Expected<void> written = writeFile(file.toStdString(), bytes);
    if (!written) {
        messages_.showError(written.error());
        return false;
    }
    model_.markSaved(removed);
    messages_.setHint(tr("The tooth was saved to %1").arg(file));
    emit toothSaved(file);
    return true;
}

void ToothController::askForTooth() {
    auto* dialog = new OpenToothDialog(files_.folder(), &window_);
    connect(dialog, &OpenToothDialog::chosen, this, [this](const ToothSource& source) { openTooth(source); });
    dialog->open();
}

void ToothController::askForScan() {
    files_.openSeveral(tr("Import a scan: surfaces of one tooth"),
                       tr("Surfaces (*.stl *.STL *.obj *.OBJ *.ply *.PLY);;All files (*)"),
                       [this](const QStringList& names) {
                           std::vector<std::filesystem::path> files;
                           for (const QString& name : names) files.emplace_back(name.toStdString());
                           if (!files.empty()) importScan(files);
                       });
}

void ToothController::askForScanFolder() {
    files_.openFolder(tr("Import a folder of scans"),
                      [this](const QString& folder) { importFolder(folder.toStdString()); });
}

void ToothController::askForBur() {
    files_.open(tr("Open bur: tip at the origin, shaft along +z, mm"),
                tr("Burs (*.stl *.STL *.obj *.ply *.toml);;All files (*)"),
                [this](const QString& file) { openBur(file); });
}

void ToothController::askForExport() {
    if (isReplaying()) return;
    files_.save(tr("Export cut tooth"), tr("STL surfaces (*.stl *.STL);;All files (*)"), "cut.stl",
                [this](const QString& file) { exportTooth(file); });
}

/// While a recording is shown, there is no tooth on the bench to write. Then it shows a message.
bool ToothController::isReplaying() const {
    const bool shows = showsRecording_ && showsRecording_();
    if (shows) messages_.setHint(tr("A recording is shown. Leave the replay to save the tooth."));
    return shows;
}

void ToothController::askForSave(const std::function<void()>& saved) {
    if (isReplaying()) return;
    files_.save(tr("Save tooth"), tr("Saved teeth (*.tactooth);;All files (*)"), "tooth.tactooth",
                [this, saved](const QString& file) {
                    if (saveTooth(file) && saved) saved();
                });
}

void ToothController::poll() {
    importer_.poll();
    caseMaker_.poll();
    if (const auto failure = loader_.poll()) {
        messages_.showError(*failure);
        emit loadingFailed();
    }
}

}  // namespace tactooth

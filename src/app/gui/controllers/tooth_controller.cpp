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
#include "geometry/io/stl_writer.h"
#include "session/cases/case_store.h"
#include "session/model/file_writer.h"
#include "session/recording/session_recorder.h"
#include "tooth/file/exported_mesh.h"
#include "tooth/file/tooth_snapshot.h"

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

/// Notes the largest share that was reported: several threads may count parts.
Task<SessionTooth>::Function withShare(const ToothController::MakeTooth& tooth,
                                       const std::shared_ptr<std::atomic<double>>& share) {
    return [tooth, share] {
        return tooth([&](double done) {
            double before = share->load();
            while (before < done && !share->compare_exchange_weak(before, done)) {
            }
        });
    };
}

/// The present tooth; where no thread works on it, the copy is made at once.
std::future<ToothSnapshot> snapshotNow(SessionModel& model) {
    if (model.runner() != nullptr) return model.runner()->snapshot();
    std::promise<ToothSnapshot> copy;
    copy.set_value(snapshotOf(model.tooth()->piece->volume(), model.tooth()->piece->removed()));
    return copy.get_future();
}

constexpr double kMade = 0.7;  // of the time: the content of a file is made, then it is written

/// What remains of the work after its share `done`.
GoesOn part(const GoesOn& goesOn, double done) {
    return [goesOn, done](double share) { return goesOn(done + (1 - done) * share); };
}

}  // namespace

ToothController::ToothController(SessionModel& model, const ExaminationMode& mode, WindowMessages& messages,
                                 FileDialogs& files, FileWriter& writer, UnsavedWork& unsaved, QWidget& window)
    : model_(model),
      mode_(mode),
      messages_(messages),
      files_(files),
      writer_(writer),
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

void ToothController::make(const MakeTooth& tooth, const QString& hint) {
    const auto share = std::make_shared<std::atomic<double>>(0);
    load(withShare(tooth, share), hint, share);
}

std::optional<LongWork> ToothController::loading() {
    if (!isBusy()) return std::nullopt;
    LongWork work{.title = tr("Loading"), .share = share_ ? std::optional(share_->load()) : std::nullopt};
    if (!model_.tooth()) return work;
    work.cancel = [this] { cancelLoading(); };
    work.cancelTip = tr("Keeps the present tooth; what is being loaded is dropped");
    return work;
}

void ToothController::cancelLoading() {
    loader_.cancel();
    messages_.setHint(tr("Loading was cancelled: the tooth stays as it is"));
    emit loadingDeclined();
}

void ToothController::loadBuiltinTooth(const BuiltinToothEntry& entry) {
    make([entry](const ShareDone& progress) { return makeSessionTooth(entry, progress); },
         tr("Making the tooth: %1…").arg(translated(entry.name)));
}

void ToothController::loadMouth(const MouthChoice& mouth) {
    make([mouth](const ShareDone& progress) { return makeSessionTooth(mouth, progress); },
         tr("Making the whole mouth around tooth %1…").arg(mouth.fdi));
}

void ToothController::openTooth(const ToothSource& source, const std::string& workOn) {
    replaceTooth([this, source, workOn] {
        const QString file = QString::fromStdString(source.outer.string());
        files_.enterFolderOf(file);
        emit fileOpened(file);
        source_ = source;
        messages_.setHint(tr("Opening %1…").arg(QString::fromStdString(source.outer.filename().string())));
        const auto share = std::make_shared<std::atomic<double>>(0);
        share_ = share;
        loader_.load(withShare(
            [source, workOn, known = knownFiles_](const ShareDone& progress) {
                return openSessionTooth(source, workOn, known, progress);
            },
            share));
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
    if (!isBusy()) share_.reset();
    loader_.load(Task<SessionBur>::Function([spec] { return makeSessionBur(spec); }));
}

void ToothController::openBur(const QString& file) {
    if (!isBusy()) share_.reset();
    files_.enterFolderOf(file);
    loader_.load(Task<SessionBur>::Function([path = file.toStdString()] { return loadSessionBur(path); }));
}

/// Another tooth may have come while the file was written.
void ToothController::markSaved(const std::shared_ptr<CutModel>& piece, const MaterialVolumes& removed) {
    if (model_.tooth() && model_.tooth()->piece == piece) model_.markSaved(removed);
}

void ToothController::exportTooth(const QString& file) {
    if (model_.runner() == nullptr && !isStill(model_)) return;
    files_.enterFolderOf(file);
    messages_.setHint(tr("Writing the tooth to %1…").arg(file));
    const MaterialVolumes removed = removedNow(model_);  // before the surface: what is cut between them is unsaved
    const std::shared_ptr<CutModel> piece = model_.tooth()->piece;
    writer_.write(
        [surface = model_.runner() != nullptr ? model_.runner()->feed().surface() : piece->surface(),
         voxel = piece->volume().lattice().spacing(),
         path = file.toStdString()](const GoesOn& goesOn) -> Expected<bool> {
            if (!goesOn(0)) return false;
            const TaggedMesh mesh = exportedMesh(*surface, voxel);
            return writeInPieces(path, stlBytes(mesh.mesh), part(goesOn, kMade));
        },
        [this, file, piece, removed](const Expected<bool>& written) {
            messages_.showWritten(written, tr("The tooth was written to %1").arg(file));
            if (written && *written) markSaved(piece, removed);
        });
}

void ToothController::saveTooth(const QString& file, const std::function<void()>& saved) {
    if (model_.runner() == nullptr && !isStill(model_)) return;
    files_.enterFolderOf(file);
    messages_.setHint(tr("Saving the tooth to %1…").arg(file));
    const auto snapshot = std::make_shared<std::shared_future<ToothSnapshot>>(snapshotNow(model_).share());
    writer_.write(
        [snapshot, provenance = savedNow(model_.tooth()->provenance),
         work = work_ ? workTextWithoutFolders(work_()) : std::string(),
         path = file.toStdString()](const GoesOn& goesOn) -> Expected<bool> {
            if (!goesOn(0)) return false;
            return writeInPieces(path, savedToothBytes(snapshot->get(), provenance, work), part(goesOn, kMade));
        },
        [this, file, saved, snapshot, piece = model_.tooth()->piece](const Expected<bool>& written) {
            messages_.showWritten(written, tr("The tooth was saved to %1").arg(file));
            if (!written || !*written) return;
            markSaved(piece, snapshot->get().removed);
            emit toothSaved(file);
            if (saved) saved();
        });
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
                [this, saved](const QString& file) { saveTooth(file, saved); });
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

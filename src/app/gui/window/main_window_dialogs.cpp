// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the window asks and says, and the files that go in and out.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/dialogs/open_tooth_dialog.h"
#include "app/gui/dialogs/scan_importer.h"
#include "app/gui/dialogs/text_dialog.h"
#include "app/gui/dialogs/welcome_dialog.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/plot_export.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "app/gui/window/main_window.h"
#include "geometry/files/atomic_file.h"
#include "geometry/io/stl_writer.h"
#include "session/cases/case_store.h"
#include "session/io/commit.h"

namespace tactooth {
namespace {

const char* const kToothFilter = QT_TRANSLATE_NOOP("tactooth::MainWindow", "Saved teeth (*.tactooth);;All files (*)");
const char* const kBurFilter =
    QT_TRANSLATE_NOOP("tactooth::MainWindow", "Burs (*.stl *.STL *.obj *.ply *.toml);;All files (*)");
const char* const kStlFilter = QT_TRANSLATE_NOOP("tactooth::MainWindow", "STL surfaces (*.stl *.STL);;All files (*)");

/// A message that does not stop the simulation.
void say(QWidget* parent, QMessageBox::Icon icon, const QString& title, const QString& text) {
    auto* box = new QMessageBox(icon, title, text, QMessageBox::Ok, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->open();
}

QFileDialog* fileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter) {
    auto* dialog = new QFileDialog(parent, title, folder, filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return dialog;
}

QString folderOf(const QString& file) { return QFileInfo(file).absolutePath(); }

}  // namespace

void MainWindow::loadBuiltinTooth(const BuiltinToothEntry& entry) {
    status_->setHint(tr("Making the tooth: %1…").arg(translated(entry.name)));
    model_.load([entry] { return makeSessionTooth(entry); });
}

void MainWindow::loadMouth(const MouthChoice& mouth) {
    status_->setHint(tr("Making the whole mouth around tooth %1…").arg(mouth.fdi));
    model_.load([mouth] { return makeSessionTooth(mouth); });
}

MainWindow::SessionState MainWindow::releaseSession() {
    SessionState work{model_.tooth(),
                      model_.bur(),
                      source_,
                      {view_->orbitCamera(), inspectionPanel_->choice(), target_, targetFile_}};
    if (work.tooth) work.tooth->exercise = activeExercise_;
    model_.stop();
    return work;
}

void MainWindow::restoreSession(SessionState work) {
    source_ = std::move(work.source);
    if (work.tooth) {
        work.tooth->bur.reset();  // it was put into the handpiece when it came; another one may be in it now
        model_.install(std::move(*work.tooth));
        pendingViewState_ = std::move(work.viewState);
    }
    if (work.bur) model_.install(std::move(*work.bur));
}

void MainWindow::openTooth(const ToothSource& source, const std::string& workOn) {
    status_->setHint(tr("Opening %1…").arg(QString::fromStdString(source.outer.filename().string())));
    folder_ = folderOf(QString::fromStdString(source.outer.string()));
    remember(QString::fromStdString(source.outer.string()));
    source_ = source;
    model_.load(Task<SessionTooth>::Function([source, workOn] { return loadSessionTooth(source, workOn); }));
}

/// A tooth, or the description of an exercise.
void MainWindow::openFile(const QString& file) {
    if (QFileInfo(file).suffix() == "toml") return openExercise(file);
    openTooth({.outer = file.toStdString(), .layers = {}});
}

void MainWindow::importScan(const std::vector<std::filesystem::path>& files) {
    folder_ = folderOf(QString::fromStdString(files.front().string()));
    importer_->begin(files, this);
}

void MainWindow::loadBur(const BurSpec& spec) {
    model_.load(Task<SessionBur>::Function([spec] { return makeSessionBur(spec); }));
}

void MainWindow::openBur(const QString& file) {
    folder_ = folderOf(file);
    model_.load(Task<SessionBur>::Function([path = file.toStdString()] { return loadSessionBur(path); }));
}

void MainWindow::exportTooth(const QString& file) {
    if (model_.simulator() == nullptr) return;
    folder_ = folderOf(file);
    const Expected<void> written = writeStl(model_.simulator()->exported().mesh, file.toStdString());
    if (!written) return showError(written.error());
    status_->setHint(tr("The tooth was written to %1").arg(file));
}

void MainWindow::saveTooth(const QString& file) {
    if (model_.simulator() == nullptr) return;
    folder_ = folderOf(file);
    const auto bytes = model_.simulator()->toothFile(savedNow(model_.tooth()->provenance));
    const Expected<void> written = writeFile(file.toStdString(), bytes);
    if (!written) return showError(written.error());
    status_->setHint(tr("The tooth was saved to %1").arg(file));
}

void MainWindow::showError(const Error& error) { showError(translated(error)); }

void MainWindow::showError(const QString& sentence) {
    status_->setHint(sentence);
    say(this, QMessageBox::Warning, tr("Tactooth"), sentence);
}

void MainWindow::askForTooth() {
    auto* dialog = new OpenToothDialog(folder_, this);
    connect(dialog, &OpenToothDialog::chosen, this, [this](const ToothSource& source) { openTooth(source); });
    dialog->open();
}

void MainWindow::askForScan() {
    QFileDialog* dialog = fileDialog(this, tr("Import a scan: surfaces of one tooth"), folder_,
                                     tr("Surfaces (*.stl *.STL *.obj *.OBJ *.ply *.PLY);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& names) {
        std::vector<std::filesystem::path> files;
        for (const QString& name : names) files.emplace_back(name.toStdString());
        if (!files.empty()) importScan(files);
    });
    dialog->open();
}

/// Another tooth of the same case to work on.
void MainWindow::fillCaseMenu() {
    caseMenu_->clear();
    const std::vector<std::string> teeth = model_.tooth() ? model_.tooth()->teethOfCase : std::vector<std::string>();
    for (const std::string& name : teeth) {
        caseMenu_->addAction(QString::fromStdString(name), this, [this, name] { openTooth(source_, name); });
    }
    if (teeth.empty()) caseMenu_->addAction(tr("Nothing yet"))->setEnabled(false);
}

void MainWindow::askForBur() {
    QFileDialog* dialog =
        fileDialog(this, tr("Open bur: tip at the origin, shaft along +z, mm"), folder_, tr(kBurFilter));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openBur);
    dialog->open();
}

/// A file without an ending gets that of `name`, which is proposed.
void MainWindow::askWhereToWrite(const QString& title, const QString& filter, const QString& name,
                                 void (MainWindow::*write)(const QString& file)) {
    QFileDialog* dialog = fileDialog(this, title, folder_, filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QFileInfo(name).suffix());
    dialog->selectFile(name);
    connect(dialog, &QFileDialog::fileSelected, this, write);
    dialog->open();
}

void MainWindow::askForExport() {
    askWhereToWrite(tr("Export cut tooth"), tr(kStlFilter), "cut.stl", &MainWindow::exportTooth);
}

void MainWindow::askForSave() {
    askWhereToWrite(tr("Save tooth"), tr(kToothFilter), "tooth.tactooth", &MainWindow::saveTooth);
}

void MainWindow::askForPlotFile() {
    askWhereToWrite(tr("Export plots: a table or a picture"), tr("Table (*.csv);;Picture (*.png);;Drawing (*.svg)"),
                    "plots.csv", &MainWindow::exportPlotsTo);
}

void MainWindow::exportPlotsTo(const QString& file) {
    folder_ = folderOf(file);
    const Expected<void> written = exportPlots(plots_->shown(), plots_->plots(), file.toStdString());
    if (!written) return showError(written.error());
    status_->setHint(tr("The plots were written to %1").arg(file));
}

void MainWindow::askForEventFile() {
    askWhereToWrite(tr("Export what happened"), tr("Table (*.csv)"), "events.csv", &MainWindow::exportEventsTo);
}

void MainWindow::exportEventsTo(const QString& file) {
    folder_ = folderOf(file);
    const Expected<void> written = writeFile(file.toStdString(), cutEventsCsv(model_.events().all()));
    if (!written) return showError(written.error());
    status_->setHint(tr("The list was written to %1").arg(file));
}

void MainWindow::remember(const QString& file) {
    constexpr qsizetype kMost = 8;  // a menu that is read at one glance
    recent_.removeAll(file);
    recent_.prepend(file);
    recent_ = recent_.mid(0, kMost);
}

void MainWindow::fillRecentMenu() {
    recentMenu_->clear();
    for (const QString& file : recent_) {
        QAction* action = recentMenu_->addAction(QFileInfo(file).fileName());
        action->setStatusTip(file);
        action->setToolTip(file);
        connect(action, &QAction::triggered, this, [this, file] { openFile(file); });
    }
    if (recent_.isEmpty()) recentMenu_->addAction(tr("Nothing yet"))->setEnabled(false);
}

void MainWindow::welcome() {
    auto* dialog = new WelcomeDialog(this);
    connect(dialog, &WelcomeDialog::toothRequested, this, &MainWindow::askForScan);
    connect(dialog, &WelcomeDialog::demonstrationRequested, this, &MainWindow::showDemonstration);
    dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

/// Cases, saved teeth and exercises are opened as they are, surfaces are looked at first.
void MainWindow::dropEvent(QDropEvent* event) {
    std::vector<std::filesystem::path> files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
    }
    if (files.empty()) return;
    event->acceptProposedAction();
    if (isCase(files.front()) || isToothFile(files.front()) || files.front().extension() == ".toml") {
        openFile(QString::fromStdString(files.front().string()));
    } else {
        importScan(files);
    }
}

/// The pedal key is the pedal, whatever has the focus, as long as no dialog is in front. A key or a click ends the
/// demonstration.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress) tour_->stop();
    if (isKey || event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove) idleSteps_ = 0;
    // Another window is in front and gets the key's release.
    if (watched == this && event->type() == QEvent::WindowDeactivate && !tour_->isRunning()) drive_->setKeyDown(false);
    if (!isKey || !watched->isWidgetType() || static_cast<QWidget*>(watched)->window() != this) {
        return QMainWindow::eventFilter(watched, event);
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() != pedalKey_) return QMainWindow::eventFilter(watched, event);
    if (!key->isAutoRepeat()) drive_->setKeyDown(event->type() == QEvent::KeyPress);
    return true;
}

void MainWindow::showMouseAndKeys() {
    const auto row = [](const QString& what, const QString& effect) {
        return "<tr><td><b>" + what + "</b>&nbsp;&nbsp;&nbsp;</td><td>" + effect + "</td></tr>";
    };
    QString text = "<table>";
    text += row(tr("Move"), tr("the bur hovers over the point under the mouse"));
    text += row(tr("Left button"), tr("the bur goes down and presses; drag to stroke or cut"));
    text += row(tr("Wheel"), tr("press harder or softer"));
    text += row(tr("Shift + move"), tr("lean the bur"));
    text += row(tr("Right button"), tr("turn the tooth"));
    text += row(tr("Middle button"), tr("shift the picture"));
    text += row(tr("Ctrl + wheel"), tr("nearer or farther"));
    text += row(tr("Arrow keys"), tr("move the bur; with Shift lean it, with Ctrl turn the tooth"));
    text += row(tr("Enter"), tr("the bur presses, as long as you hold it"));
    text += row(tr("+, -"), tr("nearer or farther"));
    text += row(tr("Space"), tr("the pedal, as long as you hold it"));
    text += row(tr("T, C"), tr("touch, cut"));
    text += row(tr("0 to 5, F"), tr("views; show the whole crown"));
    text += row(tr("Ctrl + 0 to 5"), tr("a small picture from that side beside the large one; none"));
    text += row(tr("Q, E, U"), tr("turn the handle; stand the bur upright"));
    text += row(tr("M, H"), tr("mirror, turbine on and off"));
    text += row(tr("G"), tr("the cavity that the target wants cut, on and off"));
    text += row(tr("B, D"), tr("breath and drops on the mirror"));
    text += row(tr("W, S"), tr("water spray, suction on and off"));
    text += row(tr("Ctrl + Z"), tr("take back the last cut"));
    text += row(tr("Ctrl + R"), tr("put back all that was cut"));
    text += row(tr("Ctrl + O, S, Shift + S"), tr("open a tooth, save it, export its surface"));
    text += row(tr("Ctrl + I"), tr("import a scan"));
    text += row(tr("Ctrl + D"), tr("dark colours"));
    text += row(tr("X"), tr("hold the bur while the hand of a device moves on"));
    text += row(tr("Gamepad: sticks"), tr("left: move; right: lean the bur"));
    text += row(tr("Gamepad: left trigger, shoulder"), tr("press, lift"));
    text += row(tr("Gamepad: right trigger, shoulder"), tr("pedal, hold"));
    text += row(tr("Gamepad: A, B"), tr("touch or cut, turbine or mirror"));
    text += row(tr("Gamepad: d-pad"), tr("turn the tooth; with the right shoulder shift the picture"));
    text += row(tr("Gamepad: sticks, pressed in"), tr("left: farther; right: nearer"));
    text += row(tr("Gamepad: Start, Back"), tr("open the menus; go into the panels, shoulders: the next one"));
    text += row(tr("Gamepad: d-pad, A, B"), tr("in menus, dialogs and panels: go on, choose, leave"));
    text += row(tr("Ctrl + M"), tr("mute"));
    text += row(tr("Tab, Alt + letter"), tr("go on to the next control; open a menu"));
    text += row(tr("Esc"), tr("leave a dialog"));
    (new TextDialog(tr("Mouse and keys"), text + "</table>", this))->open();
}

void MainWindow::showAbout() {
    say(this, QMessageBox::NoIcon, tr("About Tactooth"),
        tr("<b>Tactooth %1</b> (%2)<br>See, feel and hear a dental bur touch and cut a tooth.<br><br>"
           "Free software under the GNU General Public License, version 3 or later;<br>"
           "its simulation library under the Apache License 2.0.")
            .arg(TACTOOTH_VERSION, kCommit));
}

}  // namespace tactooth

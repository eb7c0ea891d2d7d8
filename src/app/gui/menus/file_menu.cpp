// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/menus/file_menu.h"

#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "app/gui/controllers/examination_controller.h"
#include "app/gui/controllers/exercise_controller.h"
#include "app/gui/controllers/recording_controller.h"
#include "app/gui/controllers/tooth_controller.h"
#include "app/gui/icons/line_icon.h"
#include "app/gui/keys/key_binding.h"
#include "app/gui/menus/menu_switch.h"
#include "app/gui/model/recent_file.h"
#include "app/gui/text/messages.h"
#include "app/gui/text/translation.h"

namespace tactooth {

FileMenu::FileMenu(QMainWindow& window, QToolBar& bar, SessionModel& model, ToothController& teeth,
                   ExerciseController& exercise, RecordingController& recordings, ExaminationController& examinations)
    : model_(model), teeth_(teeth), exercise_(exercise), chart_(window, model, teeth, exercise) {
    build(window, bar, recordings, examinations);
    connect(&teeth_, &ToothController::fileOpened, this, &FileMenu::remember);
    connect(&teeth_, &ToothController::toothSaved, this, &FileMenu::remember);
    connect(&exercise_, &ExerciseController::fileOpened, this, &FileMenu::remember);
}

void FileMenu::build(QMainWindow& window, QToolBar& bar, RecordingController& recordings,
                     ExaminationController& examinations) {
    QMenu* menu = window.menuBar()->addMenu(tr("&File"));
    const auto add = [&](const QString& text, const char* icon, const auto* receiver, auto act) {
        QAction* action = menu->addAction(text, receiver, act);
        setLineIcon(*action, icon);
        return action;
    };
    const auto addMenu = [&](const QString& text, const char* icon) {
        QMenu* result = menu->addMenu(text);
        setLineIcon(*result->menuAction(), icon);
        return result;
    };
    QAction* open = add(tr("&Open tooth…"), "open", &teeth_, &ToothController::askForTooth);
    bindKey(*open, KeyId::Open);
    QMenu* builtin = addMenu(tr("&Built-in teeth"), "tooth");
    addBuiltinTeeth(*builtin);
    menu->addAction(&chart_.action());
    recentMenu_ = addMenu(tr("Open &recent"), "recent");
    recentMenu_->setObjectName("recent");
    connect(recentMenu_, &QMenu::aboutToShow, this, &FileMenu::fillRecent);
    caseMenu_ = addMenu(tr("Tooth of the &case"), "case");
    caseMenu_->setObjectName("teethOfCase");
    connect(caseMenu_, &QMenu::aboutToShow, this, &FileMenu::fillCase);
    bindKey(*add(tr("&Import scan…"), "import", &teeth_, &ToothController::askForScan), KeyId::Import);
    add(tr("Import a &folder of scans…"), "import", &teeth_, &ToothController::askForScanFolder);
    QAction* bur = add(tr("Open &bur…"), "bur", &teeth_, &ToothController::askForBur);
    bur->setObjectName("openBur");
    connect(&exercise_, &ExerciseController::activeChanged, bur, [this, bur] {
        const bool isAllowed = exercise_.active() == nullptr || !exercise_.active()->onlyTheseBurs;
        bur->setEnabled(isAllowed);
        bur->setToolTip(isAllowed ? QString() : translated(msg::kBurNotAllowed));
    });
    add(tr("Open e&xercise…"), "exercise", &exercise_, &ExerciseController::askForExercise);
    add(tr("Open recor&ding…"), "recording", this, &FileMenu::recordingWanted);
    bindKey(*add(tr("&Save tooth…"), "save", &teeth_, [this] { teeth_.askForSave(); }), KeyId::Save);
    QAction* save = add(tr("&Export cut tooth…"), "export", &teeth_, &ToothController::askForExport);
    bindKey(*save, KeyId::Export);
    recordings.addTo(*menu);
    examinations.addTo(*menu);
    menu->addSeparator();
    bindKey(*add(tr("Se&ttings…"), "settings", this, &FileMenu::settingsWanted), KeyId::Settings);
    add(tr("&Keys…"), "keys", this, &FileMenu::keysWanted);
    menu->addSeparator();
    quit_ = add(tr("&Quit"), "quit", &window, &QWidget::close);
    bindKey(*quit_, KeyId::Quit);
    for (QAction* action : {open, save}) hideMarkInBars(*action);
    bar.addActions({open, &chart_.action(), save});
}

void FileMenu::addBuiltinTeeth(QMenu& menu) {
    for (const BuiltinToothEntry& entry : kBuiltinTeeth) {
        menu.addAction(translated(entry.name), this, [this, &entry] { teeth_.loadBuiltinTooth(entry); });
    }
}

void FileMenu::remember(const QString& file) {
    constexpr qsizetype kMost = 8;  // the user takes in such a menu at one glance
    QStringList files = recent_;
    files.removeAll(file);
    files.prepend(file);
    setRecent(files.mid(0, kMost));
}

void FileMenu::setRecent(const QStringList& files) {
    recent_ = files;
    teeth_.setKnownFiles(openedFiles(recent_));
}

void FileMenu::fillRecent() {
    recentMenu_->clear();
    for (const QString& text : recent_) {
        const RecentFile recent = RecentFile::fromText(text);
        const QString name = QFileInfo(recent.files.front()).fileName();
        QAction* action = recentMenu_->addAction(recent.isScan ? tr("Import %1…").arg(name) : name);
        action->setStatusTip(recent.files.join(", "));
        action->setToolTip(recent.files.join('\n'));
        connect(action, &QAction::triggered, this, [this, text] { teeth_.openFile(text); });
    }
    if (recent_.isEmpty()) recentMenu_->addAction(tr("Nothing yet"))->setEnabled(false);
}

/// The other teeth of the case that is open.
void FileMenu::fillCase() {
    caseMenu_->clear();
    const std::vector<std::string> names = model_.tooth() ? model_.tooth()->teethOfCase : std::vector<std::string>();
    for (const std::string& name : names) {
        caseMenu_->addAction(QString::fromStdString(name), this, [this, name] { teeth_.openToothOfCase(name); });
    }
    if (names.empty()) caseMenu_->addAction(tr("Nothing yet"))->setEnabled(false);
}

void FileMenu::restore(const WindowSettings& settings) {
    setRecent(QString::fromStdString(settings.recent).split('\n', Qt::SkipEmptyParts));
    chart_.restore(settings);
}

void FileMenu::store(WindowSettings& settings) const {
    settings.recent = recent_.join('\n').toStdString();
    chart_.store(settings);
}

}  // namespace tactooth

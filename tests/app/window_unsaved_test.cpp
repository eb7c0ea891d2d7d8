// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// No path of the window loses cuts that are not saved.
#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDesktopServices>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QTableWidget>
#include <filesystem>
#include <functional>
#include <set>

#include "app/gui/dialogs/open_tooth_dialog.h"
#include "app/gui/model/tooth_chart_layout.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "geometry/io/stl_writer.h"
#include "session/recording/recording_folder.h"
#include "support/shapes.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

}  // namespace

class WindowUnsavedTest : public test::WindowSession {
    Q_OBJECT

public slots:
    /// In place of the desktop's file manager.
    void openUrl(const QUrl& url) { opened_ = url; }

private slots:
    void initTestCase();
    void aStarShowsUnsavedCuts();
    void noEntryOfAnyMenuLosesThem();
    void everyToothOfTheChartIsAskedAbout();
    void filesThatAreChosenInDialogsAreAskedAbout();
    void droppedFilesAreAskedAbout();
    void anExerciseIsAskedAboutAndTheListShowsTheOneBefore();
    void theWindowStaysOpen();
    void savingGoesOnAfterwards();
    void savingThatIsGivenUpLosesNothing();
    void afterAnExportNothingIsAsked();
    void undoAndRedoGoThroughCutsResetsAndChanges();
    void aSavedToothGoesOnWithItsExercise();
    void aSignalSavesAndTheNextStartRestores();
    void recordingsAreSwitchedInTheMenu();
    void cleanupTestCase();

private:
    [[nodiscard]] std::vector<QAction*> leaves() const;
    void drop(const fs::path& file) const;
    void chooseInDialog(const fs::path& file) const;
    [[nodiscard]] bool isAsked() const { return unsavedQuestion() != nullptr && unsavedQuestion()->isVisible(); }
    /// The question comes; the answer keeps the tooth.
    void expectQuestion(const QString& after);
    void leaveDialogs() const;
    [[nodiscard]] std::vector<fs::path> recordings() const;

    fs::path tooth_, exercise_;
    const CutModel* piece_ = nullptr;  // with the unsaved cuts
    double cut_ = 0;
    QUrl opened_;
};

void WindowUnsavedTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());
    QDesktopServices::setUrlHandler("file", this, "openUrl");
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
    tooth_ = folder_ / "ball.stl";
    QVERIFY(writeStl(test::sphere(Vec3(20, 0, 0), 5, 40, 30), tooth_).has_value());
    exercise_ = folder_ / "own.toml";
    test::writeText(exercise_,
                    "name = \"Distal pit\"\ntask = \"Deep down.\"\ntooth = 46\nbur = \"245\"\n"
                    "[cavity]\ndepth = 1.2\n[[cavity.strokes]]\nfrom = [2, 0, 0]\n");
}

void WindowUnsavedTest::cleanupTestCase() {
    QDesktopServices::unsetUrlHandler("file");
    closeWindow();
}

std::vector<fs::path> WindowUnsavedTest::recordings() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_ / "recordings")) files.push_back(entry.path());
    return files;
}

std::vector<QAction*> WindowUnsavedTest::leaves() const {
    std::vector<QAction*> result;
    const std::function<void(QMenu&)> collect = [&](QMenu& menu) {
        emit menu.aboutToShow();  // fills the menus of recent files and of the case
        for (QAction* entry : menu.actions()) {
            if (entry->menu() != nullptr) collect(*entry->menu());
            if (entry->menu() == nullptr && !entry->isSeparator()) result.push_back(entry);
        }
    };
    for (QAction* top : window_->menuBar()->actions()) collect(*top->menu());
    return result;
}

void WindowUnsavedTest::leaveDialogs() const {
    for (int i = 0; i < 5; ++i) {
        QDialog* front = nullptr;
        for (QWidget* each : QApplication::topLevelWidgets()) {  // the manual has no parent
            auto* dialog = qobject_cast<QDialog*>(each);
            if (dialog != nullptr && dialog->isVisible()) front = dialog;
        }
        if (front == nullptr) return;
        QTest::keyClick(front, Qt::Key_Escape);
        (void)QTest::qWaitFor([dialog = QPointer(front)] { return dialog == nullptr || !dialog->isVisible(); }, 10'000);
    }
}

void WindowUnsavedTest::expectQuestion(const QString& after) {
    QTRY_VERIFY2_WITH_TIMEOUT(isAsked(), qPrintable(after), kPatience);
    answerUnsaved(QMessageBox::Cancel);
    waitForSteps(3);
    QVERIFY2(!window_->isBusy(), qPrintable(after));
    QVERIFY2(window_->model().tooth()->piece.get() == piece_, qPrintable(after));
    QVERIFY2(removed() == cut_, qPrintable(after));
    QVERIFY2(window_->isWindowModified(), qPrintable(after));
}

void WindowUnsavedTest::aStarShowsUnsavedCuts() {
    QVERIFY(!window_->isWindowModified());
    cutALittle();
    QTRY_VERIFY_WITH_TIMEOUT(window_->isWindowModified(), kPatience);
    QVERIFY(window_->windowTitle().contains("[*]"));
    piece_ = window_->model().tooth()->piece.get();
    cut_ = removed();
}

/// Walks through all entries, also those that are added later: whatever they do, the cuts are there afterwards, or one
/// undo brings them back.
void WindowUnsavedTest::noEntryOfAnyMenuLosesThem() {
    const WindowSettings before = window_->settings();
    std::set<QString> asked;
    const std::size_t count = leaves().size();
    for (std::size_t i = 0; i < count; ++i) {
        QAction* const entry = leaves().at(i);  // menus may be filled anew
        if (!entry->isEnabled()) continue;
        const QString text = entry->text();
        if (entry->parent() != nullptr && entry->parent()->objectName() == "language") continue;  // keeps the work
        if (text.contains("demonstration")) continue;  // it cuts, and takes back what it cut
        entry->trigger();
        if (isAsked()) {
            asked.insert(text);
            expectQuestion(text);
            continue;
        }
        leaveDialogs();
        waitForSteps(5);
        waitForTooth();
        waitForCarving();  // a reset or an undo comes late on a busy machine
        QVERIFY2(window_->model().tooth()->piece.get() == piece_, qPrintable(text));
        if (removed() == cut_) continue;
        const bool isUndo = window_->model().history().position() < window_->model().history().steps().size();
        key(Qt::Key_Z, isUndo ? Qt::ControlModifier | Qt::ShiftModifier : Qt::ControlModifier);
        QTRY_VERIFY2_WITH_TIMEOUT(removed() == cut_, qPrintable(text), kPatience);
    }
    QVERIFY2(asked.contains("&Quit"), qPrintable(QStringList(asked.begin(), asked.end()).join(", ")));
    QVERIFY2(asked.size() >= 1 + kBuiltinTeeth.size(), qPrintable(QString::number(asked.size())));
    window_->apply(before);
    waitForTooth();
    QVERIFY(removed() == cut_);
}

void WindowUnsavedTest::everyToothOfTheChartIsAskedAbout() {
    for (const ChartTooth& tooth : toothChartLayout().teeth) {
        key(Qt::Key_T, Qt::ControlModifier);
        auto* button = window_->findChild<QAbstractButton*>(QString("tooth%1").arg(tooth.fdi));
        QVERIFY2(button != nullptr, qPrintable(QString::number(tooth.fdi)));
        button->click();
        expectQuestion(QString("tooth %1 of the chart").arg(tooth.fdi));
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QDialog*>("toothChartDialog") == nullptr, kPatience);
    }
}

void WindowUnsavedTest::chooseInDialog(const fs::path& file) const {
    QFileDialog* dialog = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((dialog = window_->findChild<QFileDialog*>()) != nullptr, kPatience);
    dialog->setDirectory(QString::fromStdString(file.parent_path().string()));
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(QString::fromStdString(file.string()));
    QMetaObject::invokeMethod(dialog, "accept");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() == nullptr, kPatience);
}

void WindowUnsavedTest::filesThatAreChosenInDialogsAreAskedAbout() {
    key(Qt::Key_O, Qt::ControlModifier);
    auto* dialog = window_->findChild<OpenToothDialog*>();
    QVERIFY(dialog != nullptr);
    auto* line = dialog->findChild<QLineEdit*>("outerSurface");
    QTest::keyClicks(line, QString::fromStdString(tooth_.string()));
    QTest::keyClick(line, Qt::Key_Return);
    expectQuestion("Open tooth");
    QVERIFY(window_->settings().recent.find("ball.stl") == std::string::npos);

    key(Qt::Key_I, Qt::ControlModifier);
    chooseInDialog(tooth_);
    expectQuestion("Import scan");

    for (QAction* entry : leaves()) {
        if (entry->text() == "Open e&xercise…") entry->trigger();
    }
    chooseInDialog(exercise_);
    expectQuestion("Open exercise");
}

void WindowUnsavedTest::drop(const fs::path& file) const {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
    QDragEnterEvent enter(window_->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &enter);  // without it Qt drops nothing
    QDropEvent event(window_->rect().center(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &event);
}

void WindowUnsavedTest::droppedFilesAreAskedAbout() {
    const fs::path saved = folder_ / "other.tactooth";
    QVERIFY(saveTooth(*window_->model().tooth()->piece, {}, saved).has_value());
    for (const fs::path& file : {tooth_, exercise_, saved}) {
        drop(file);
        expectQuestion(QString::fromStdString(file.string()));
    }
}

void WindowUnsavedTest::anExerciseIsAskedAboutAndTheListShowsTheOneBefore() {
    auto* choice = window_->findChild<QComboBox*>("exercise");
    QCOMPARE(choice->currentIndex(), 0);
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Down);
    expectQuestion("exercise");
    QCOMPARE(choice->currentIndex(), 0);
}

void WindowUnsavedTest::theWindowStaysOpen() {
    QVERIFY(!window_->close());
    expectQuestion("close");
    key(Qt::Key_Q, Qt::ControlModifier);
    expectQuestion("Ctrl+Q");
    QVERIFY(!window_->close());
    QVERIFY(!window_->close());  // one question is enough
    QCOMPARE(window_->findChildren<QMessageBox*>("unsavedWork").size(), 1);
    expectQuestion("close twice");
    QVERIFY(window_->isVisible());
}

void WindowUnsavedTest::savingThatIsGivenUpLosesNothing() {
    cutALittle();
    cut_ = removed();
    piece_ = window_->model().tooth()->piece.get();
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    QVERIFY(isAsked());
    answerUnsaved(QMessageBox::Save);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    leaveDialogs();
    waitForSteps(3);
    QVERIFY(window_->model().tooth()->piece.get() == piece_ && removed() == cut_);
    QVERIFY(window_->isWindowModified());
}

void WindowUnsavedTest::savingGoesOnAfterwards() {
    const fs::path file = folder_ / "saved.tactooth";
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    QVERIFY(isAsked());
    answerUnsaved(QMessageBox::Save);
    chooseInDialog(file);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->name, std::string(kBuiltinTeeth[1].name), kLoadPatience);
    waitForTooth();
    const Expected<OpenedTooth> saved = openTooth(file);
    QVERIFY2(saved.has_value(), saved ? "" : saved.error().message().c_str());
    QCOMPARE(total(saved->piece->removed()), cut_);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);
}

void WindowUnsavedTest::afterAnExportNothingIsAsked() {
    QVERIFY(window_->isWindowModified());
    window_->teeth().exportTooth(QString::fromStdString((folder_ / "cut.stl").string()));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    QVERIFY(!isAsked());
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("molar"), kLoadPatience);
    waitForTooth();
}

void WindowUnsavedTest::undoAndRedoGoThroughCutsResetsAndChanges() {
    const auto undo = [this] { key(Qt::Key_Z, Qt::ControlModifier); };
    const auto redo = [this] { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); };
    auto* lines = window_->findChild<QListWidget*>("history");
    auto* events = window_->findChild<QTableWidget*>("events");
    QTRY_COMPARE_WITH_TIMEOUT(lines->count(), 1, kPatience);
    cutALittle();
    const double first = removed();
    QTRY_COMPARE_WITH_TIMEOUT(lines->count(), 2, kPatience);
    const bool water = window_->settings().water;
    key(Qt::Key_W);
    QTRY_COMPARE_WITH_TIMEOUT(lines->count(), 3, kPatience);
    key(Qt::Key_R, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(lines->count(), 4, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(events->rowCount() > 0 && events->item(0, 1)->font().strikeOut(), kPatience);
    undo();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), first, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!events->item(0, 1)->font().strikeOut(), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(window_->settings().water, !water, kPatience);
    undo();
    QTRY_COMPARE_WITH_TIMEOUT(window_->settings().water, water, kPatience);
    undo();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    for (int i = 0; i < 2; ++i) redo();
    key(Qt::Key_Y, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().history().position(), std::size_t{3}, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(window_->settings().water, !water, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    emit lines->itemClicked(lines->item(1));
    QTRY_COMPARE_WITH_TIMEOUT(removed(), first, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(lines->currentRow(), 1, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(window_->settings().water, water, kPatience);
}

void WindowUnsavedTest::aSavedToothGoesOnWithItsExercise() {
    drop(exercise_);
    answerUnsaved(QMessageBox::Discard);
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("Distal pit"), kLoadPatience);
    waitForTooth();
    cutALittle();
    const double cut = removed();
    const double seconds = window_->model().log().workSeconds();
    QVERIFY(seconds > 0);
    const fs::path file = folder_ / "lesson.tactooth";
    window_->teeth().saveTooth(QString::fromStdString(file.string()));
    waitForFiles();
    loadMolar();
    window_->teeth().openTooth({.outer = file, .layers = {}});
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("Distal pit"), kLoadPatience);
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), cut, kPatience);
    QCOMPARE(window_->findChild<QComboBox*>("exercise")->currentText(), "Distal pit");
    QVERIFY(window_->model().log().workSeconds() >= seconds);
    QTRY_VERIFY_WITH_TIMEOUT(QString::fromStdString(window_->model().bur()->name).contains("245"), kLoadPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);
}

void WindowUnsavedTest::aSignalSavesAndTheNextStartRestores() {
    cutALittle();
    const double cut = removed();
    const std::size_t before = recordings().size();
    window_->saveBeforeEnd();
    QVERIFY(window_->close());                  // without a question
    QCOMPARE(recordings().size(), before + 1);  // the tooth; the recording has its final name now
    for (const fs::path& file : recordings()) QVERIFY(!file.filename().string().starts_with("live-"));
    closeWindow();

    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
    window_->restorer().offer();
    QMessageBox* question = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((question = window_->findChild<QMessageBox*>("restoreSession")) != nullptr, kPatience);
    QVERIFY(question->text().contains("Restore the session of"));
    QVERIFY(QTest::qWaitForWindowExposed(question, kPatience));
    QTest::mouseClick(question->defaultButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(window_->windowTitle().contains("Distal pit"), kLoadPatience);
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), cut, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isWindowModified(), kPatience);
    QVERIFY(RecordingFolder(folder_ / "recordings").leftovers().empty());
}

void WindowUnsavedTest::recordingsAreSwitchedInTheMenu() {
    const auto* sign = window_->findChild<QLabel*>("recordingSign");
    QTRY_VERIFY_WITH_TIMEOUT(sign->isVisible(), kPatience);
    auto* record = window_->recordings().findChild<QAction*>("recordSessions");
    QVERIFY(record->isChecked());
    record->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->model().isRecording() && !sign->isVisible(), kPatience);
    QVERIFY(!window_->settings().recordsSessions);
    waitForTooth();
    record->trigger();
    loadMolar();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().isRecording(), kPatience);
    window_->recordings().findChild<QAction*>("openRecordings")->trigger();
    QCOMPARE(opened_.toLocalFile().toStdString(), (folder_ / "recordings").string());
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowUnsavedTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_unsaved_test.moc"

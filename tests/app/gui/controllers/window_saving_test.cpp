// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files are written in the background, and nothing is lost meanwhile.
#include <QProgressBar>
#include <QToolButton>
#include <filesystem>
#include <iterator>

#include "app/gui/controllers/writer_gate.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "geometry/io/mesh_file.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

}  // namespace

class WindowSavingTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void theStarStaysUntilTheFileIsWritten();
    void aCutMadeMeanwhileKeepsTheStar();
    void aResetMeanwhileIsNotInTheFile();
    void aFailureKeepsTheStarAndSaysWhy();
    void cancelLeavesTheOlderFileAndTheStar();
    void allExportsAreWrittenInTheBackground();
    void anotherToothWaitsForTheFile();
    void anotherToothIsAskedAboutAfterACutMeanwhile();
    void aFailureKeepsTheWindowOpen();
    void theWindowClosesAfterTheFile();
    void theEndOfTheProgramWaitsForTheFile();
    void cleanupTestCase() { closeWindow(); }

private:
    void open();
    void save(const fs::path& file) { window_->teeth().saveTooth(QString::fromStdString(file.string())); }
    [[nodiscard]] double removedIn(const fs::path& file) const {
        const Expected<OpenedTooth> saved = openTooth(file);
        return saved ? total(saved->piece->removed()) : -1;
    }
    [[nodiscard]] std::ptrdiff_t filesIn(const fs::path& folder) const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }
};

void WindowSavingTest::open() {
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
    cutALittle();
    QTRY_VERIFY_WITH_TIMEOUT(window_->isWindowModified(), kPatience);
}

void WindowSavingTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());
    open();
}

void WindowSavingTest::theStarStaysUntilTheFileIsWritten() {
    const fs::path file = folder_ / "first.tactooth";
    test::WriterGate gate(window_->writer());
    save(file);
    QVERIFY(window_->isWriting());
    waitForSteps(5);  // the window goes on
    QVERIFY(!fs::exists(file));
    QVERIFY(window_->isWindowModified());
    gate.open();
    waitForFiles();
    QCOMPARE(removedIn(file), removed());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);
}

void WindowSavingTest::aCutMadeMeanwhileKeepsTheStar() {
    const fs::path file = folder_ / "second.tactooth";
    const double before = removed();
    test::WriterGate gate(window_->writer());
    save(file);
    cutALittle();
    QVERIFY(removed() > before);
    gate.open();
    waitForFiles();
    waitForSteps(2);
    QVERIFY(window_->isWindowModified());
    QCOMPARE(removedIn(file), before);  // as the tooth was when it was saved
}

void WindowSavingTest::aResetMeanwhileIsNotInTheFile() {
    const fs::path file = folder_ / "third.tactooth";
    const double before = removed();
    test::WriterGate gate(window_->writer());
    save(file);
    window_->model().resetTooth();  // before the window has made a step
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    gate.open();
    waitForFiles();
    QCOMPARE(removedIn(file), before);
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), before, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);  // it is what was saved
    cutALittle();
    QTRY_VERIFY_WITH_TIMEOUT(window_->isWindowModified(), kPatience);
}

void WindowSavingTest::aFailureKeepsTheStarAndSaysWhy() {
    save(folder_ / "no such folder/x.tactooth");
    waitForFiles();
    QVERIFY(dismissMessage().contains("no such folder"));
    waitForSteps(2);
    QVERIFY(window_->isWindowModified());
}

void WindowSavingTest::cancelLeavesTheOlderFileAndTheStar() {
    fs::create_directories(folder_ / "alone");
    const fs::path file = folder_ / "alone/older.tactooth";
    test::writeText(file, "older");
    test::WriterGate gate(window_->writer());
    save(file);
    auto* bar = window_->findChild<QProgressBar*>("loadProgress");
    auto* cancel = window_->findChild<QToolButton*>("cancelLoading");
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && cancel->isVisible(), kPatience);
    QCOMPARE(bar->maximum(), 100);
    QTest::mouseClick(cancel, Qt::LeftButton);
    gate.open();
    waitForFiles();
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), kPatience);
    QCOMPARE(test::readText(file), std::string("older"));
    QCOMPARE(filesIn(folder_ / "alone"), 1);
    QVERIFY(window_->isWindowModified());
    QVERIFY(window_->findChild<QMessageBox*>() == nullptr);
}

void WindowSavingTest::allExportsAreWrittenInTheBackground() {
    const fs::path folder = folder_ / "exports";
    fs::create_directories(folder);
    const auto in = [&](const char* name) { return QString::fromStdString((folder / name).string()); };
    test::WriterGate gate(window_->writer());
    window_->teeth().exportTooth(in("cut.stl"));
    window_->records().exportEventsTo(in("events.csv"));
    for (const char* name : {"plots.csv", "plots.png", "plots.svg"}) window_->records().exportPlotsTo(in(name));
    window_->exercise().exportReport(in("report.csv"));
    QCOMPARE(filesIn(folder), 0);
    QVERIFY(window_->isWindowModified());
    gate.open();
    waitForFiles();
    QCOMPARE(filesIn(folder), 6);
    QVERIFY(loadMesh(folder / "cut.stl").has_value());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);  // by the surface
}

void WindowSavingTest::anotherToothWaitsForTheFile() {
    cutALittle();
    const CutModel* const piece = window_->model().tooth()->piece.get();
    const double cut = removed();
    const fs::path file = folder_ / "kept.tactooth";
    test::WriterGate gate(window_->writer());
    save(file);
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    waitForSteps(5);
    QVERIFY(unsavedQuestion() == nullptr && !window_->isBusy());
    QVERIFY(window_->model().tooth()->piece.get() == piece);
    gate.open();
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->name, std::string(kBuiltinTeeth[1].name), kLoadPatience);
    QVERIFY(unsavedQuestion() == nullptr);
    QCOMPARE(removedIn(file), cut);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kPatience);
}

void WindowSavingTest::anotherToothIsAskedAboutAfterACutMeanwhile() {
    loadMolar();
    cutALittle();
    test::WriterGate gate(window_->writer());
    save(folder_ / "kept.tactooth");
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    cutALittle();
    const double cut = removed();
    gate.open();
    QTRY_VERIFY_WITH_TIMEOUT(unsavedQuestion() != nullptr, kPatience);
    answerUnsaved(QMessageBox::Cancel);
    waitForSteps(3);
    QVERIFY(!window_->isBusy());
    QCOMPARE(removed(), cut);
}

void WindowSavingTest::aFailureKeepsTheWindowOpen() {
    test::WriterGate gate(window_->writer());
    save(folder_ / "no such folder/x.tactooth");
    QVERIFY(!window_->close());
    gate.open();
    waitForFiles();
    waitForSteps(3);
    QVERIFY(window_->isVisible());
    QVERIFY(unsavedQuestion() == nullptr);
    QVERIFY(dismissMessage().contains("no such folder"));
}

void WindowSavingTest::theWindowClosesAfterTheFile() {
    const double cut = removed();
    const fs::path file = folder_ / "last.tactooth";
    test::WriterGate gate(window_->writer());
    save(file);
    QVERIFY(!window_->close());
    waitForSteps(3);
    QVERIFY(window_->isVisible() && !fs::exists(file));
    gate.open();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isVisible(), kPatience);
    QVERIFY(unsavedQuestion() == nullptr);
    QCOMPARE(removedIn(file), cut);
    closeWindow();
}

/// Nobody can be asked then, as after a signal.
void WindowSavingTest::theEndOfTheProgramWaitsForTheFile() {
    open();
    const double cut = removed();
    const fs::path file = folder_ / "end.tactooth";
    {
        test::WriterGate gate(window_->writer());
        save(file);
    }
    window_->saveBeforeEnd();
    QVERIFY(!window_->isWriting());
    QCOMPARE(removedIn(file), cut);
    QVERIFY(window_->recordings().folder().leftovers().empty());  // it is saved: the next start asks about nothing
    QVERIFY(window_->close());
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowSavingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_saving_test.moc"

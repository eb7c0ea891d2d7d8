// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// *Finish*: an exercise is assessed in the window, with the mark of the command line, and its report leads on.
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <filesystem>

#include "app/gui/controllers/writer_gate.h"
#include "app/gui/finish/report_pages_view.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "cli/run_program.h"
#include "session/recording/recording_seal.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr auto kExercise = "pit-46";

QByteArray content(const fs::path& file) {
    QFile opened(QString::fromStdString(file.string()));
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

QJsonObject json(const fs::path& file) { return QJsonDocument::fromJson(content(file)).object(); }

}  // namespace

class WindowFinishTest : public test::WindowSession {
    Q_OBJECT

public:
    /// The report in both languages and both colours.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void withoutAnExerciseItSaysWhyItIsOff();
    void itAssessesInTheBackgroundAndCancelGoesOn();
    void theStatusLineShowsHowFarItIsAndCancels();
    void theReportShowsTheMarkAndWhatItIsMadeOf();
    void aHandInThatIsCancelledLeavesNothing();
    void whatIsHandedInLiesInOneFolder();
    void theCommandLineGivesTheSameMark();
    void anErrorIsReplayedFromShortlyBeforeIt();
    void whatHasNoMomentIsNotReplayed();
    void afterClosingTheTimeStandsStillUntilTheStudentCuts();
    void continueLetsTheTimeGoOn();
    void againAsksBeforeCutsAreLost();
    void anExaminationEndsWithHandingInAlone();
    void withoutARecordingNothingIsReplayed();
    void cleanupTestCase();

private:
    [[nodiscard]] QAction& action() const { return *window_->findChild<QAction*>("finishExercise"); }
    [[nodiscard]] QDialog* report() const { return window_->findChild<QDialog*>("report"); }
    [[nodiscard]] QTreeWidget& list() const { return *window_->findChild<QTreeWidget*>("lostPoints"); }
    void click(const char* button) const {
        QTest::mouseClick(window_->findChild<QPushButton*>(button), Qt::LeftButton);
    }
    [[nodiscard]] QString time() const {
        for (const QLabel* label : window_->findChildren<QLabel*>())
            if (label->accessibleName() == "Time") return label->text();
        return {};
    }
    void startExercise();
    void finish();
    /// Selects the first criterion with a moment, or without one.
    [[nodiscard]] bool select(bool hasMoment) const;
    void handIn(const QString& name);

    fs::path handedIn_;
    QString mark_;
};

void WindowFinishTest::initTestCase() {
    qputenv("XDG_DATA_HOME", (folder_ / "data").c_str());
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>())
        if (dock->findChild<QToolButton*>("finish") != nullptr) dock->raise();
}

void WindowFinishTest::cleanupTestCase() { closeWindow(); }

void WindowFinishTest::startExercise() {
    const CutModel* const before = window_->model().tooth()->piece.get();
    window_->exercise().start(builtinExercise(kExercise));
    answerUnsaved(QMessageBox::Discard);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().tooth()->piece.get() != before, kLoadPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
}

void WindowFinishTest::finish() {
    key(Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(report() != nullptr && report()->isVisible(), kLoadPatience);
}

bool WindowFinishTest::select(bool hasMoment) const {
    for (int i = 0; i < list().topLevelItemCount(); ++i) {
        QTreeWidgetItem* const item = list().topLevelItem(i);
        if (item->text(3).contains(':') != hasMoment) continue;
        list().setCurrentItem(item);
        return true;
    }
    return false;
}

void WindowFinishTest::handIn(const QString& name) {
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QDialog*>("handIn") != nullptr, kLoadPatience);
    QTest::keyClicks(window_->findChild<QLineEdit*>("handInName"), name);
    window_->findChild<QPlainTextEdit*>("handInComment")->setPlainText("Well done.");
    const fs::path in = folder_ / "handed in";
    fs::create_directories(in);
    const auto count = std::distance(fs::directory_iterator(in), fs::directory_iterator());
    window_->findChild<QLineEdit*>("handInFolder")->setText(QString::fromStdString(in.string()));
    click("handInWrite");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QDialog*>("handIn") == nullptr, kPatience);
    QCOMPARE(std::distance(fs::directory_iterator(in), fs::directory_iterator()), count + 1);
    for (const auto& folder : fs::directory_iterator(in)) {
        if (folder.path().string().ends_with(name.toStdString())) handedIn_ = folder.path();
    }
}

void WindowFinishTest::withoutAnExerciseItSaysWhyItIsOff() {
    QTRY_VERIFY_WITH_TIMEOUT(action().toolTip().startsWith("Choose an exercise"), kPatience);
    QVERIFY(!action().isEnabled());
    QVERIFY(!window_->findChild<QToolButton*>("finish")->isEnabled());
    startExercise();
    QVERIFY(action().toolTip().contains("Ctrl+E"));
    QCOMPARE(action().text(), "&Finish exercise");
}

void WindowFinishTest::itAssessesInTheBackgroundAndCancelGoesOn() {
    window_->model().manipulator().setPressDepth(2);
    cutALittle();
    const double before = removed();
    window_->findChild<QToolButton*>("finish")->click();
    QVERIFY(window_->finish().isAssessing());  // it has returned at once
    QVERIFY(window_->model().runner() == nullptr);
    QVERIFY(!action().isEnabled());
    window_->finish().assessing()->cancel();
    QVERIFY(!window_->finish().isAssessing());
    QVERIFY(!window_->exercise().isClockStopped());
    waitForTooth();
    QCOMPARE(removed(), before);
    QVERIFY(report() == nullptr);
}

void WindowFinishTest::theStatusLineShowsHowFarItIsAndCancels() {
    StatusLine line;
    line.setVisible(true);
    int cancelled = 0;
    const auto work = [&] { return LongWork{.title = "Assessing", .share = 0.4, .cancel = [&] { ++cancelled; }}; };
    QTRY_VERIFY_WITH_TIMEOUT(line.showWork(work()), kPatience);
    QCOMPARE(line.findChild<QProgressBar*>("loadProgress")->value(), 40);
    QTest::mouseClick(line.findChild<QToolButton*>("cancelLoading"), Qt::LeftButton);
    QCOMPARE(cancelled, 1);
}

void WindowFinishTest::theReportShowsTheMarkAndWhatItIsMadeOf() {
    QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
    finish();
    mark_ = window_->findChild<QLabel*>("mark")->text();
    const AssessmentReport& shown = window_->finish().assessment()->report;
    QCOMPARE(mark_.toDouble(), *shown.mark.value);
    QVERIFY(window_->findChild<QLabel*>("result")->text().contains(shown.mark.passes ? "Passed" : "Not passed"));
    QCOMPARE(list().topLevelItemCount(), static_cast<int>(shown.mark.criteria.size()));
    QVERIFY(window_->findChild<ReportPagesView*>()->pages() >= 2);
    QCOMPARE(shown.pictures.size(), std::size_t{6});
    QVERIFY(shown.strip.has_value());
    QVERIFY(window_->model().runner() == nullptr);
    QVERIFY(window_->exercise().isClockStopped());
}

void WindowFinishTest::aHandInThatIsCancelledLeavesNothing() {
    click("reportHandIn");
    QPointer<QDialog> dialog = window_->findChild<QDialog*>("handIn");
    QVERIFY(dialog != nullptr);
    const fs::path in = folder_ / "cancelled";
    fs::create_directories(in);
    window_->findChild<QLineEdit*>("handInFolder")->setText(QString::fromStdString(in.string()));
    test::WriterGate gate(window_->writer());
    click("handInWrite");
    QVERIFY(window_->isWriting() && !window_->findChild<QPushButton*>("handInWrite")->isEnabled());
    QTest::keyClick(dialog, Qt::Key_Escape);
    gate.open();
    waitForFiles();
    QTRY_VERIFY_WITH_TIMEOUT(dialog == nullptr, kPatience);
    QVERIFY(fs::is_empty(in));
    QVERIFY(report()->isVisible());
    QVERIFY(window_->findChild<QLabel*>("handedIn")->text().isEmpty());
    QVERIFY(window_->isWindowModified());  // the tooth is nowhere else
}

void WindowFinishTest::whatIsHandedInLiesInOneFolder() {
    QVERIFY(window_->isWindowModified());
    click("reportHandIn");
    handIn("Aoi Sato");
    QVERIFY(!handedIn_.empty());
    for (const char* name :
         {"report.html", "report.pdf", "report.json", "report.csv", "tooth.tactooth", "recording.ttsession"}) {
        QVERIFY2(fs::file_size(handedIn_ / name) > 0, name);
    }
    QVERIFY(content(handedIn_ / "report.html").contains("Aoi Sato"));
    QVERIFY(content(handedIn_ / "report.html").contains("Well done."));
    QVERIFY(window_->findChild<QLabel*>("handedIn")->text().contains(QString::fromStdString(handedIn_.string())));
    waitForSteps(2);
    QVERIFY(!window_->isWindowModified());  // the folder holds the tooth
    const auto recording = SessionRecording::open(handedIn_ / "recording.ttsession");
    QVERIFY(recording.has_value());
    const auto mirror = recording->mirror();
    QVERIFY(mirror.has_value());
    QVERIFY(std::ranges::any_of(*mirror, [](const MirrorMoment& each) { return each.sight.isShown; }));
    QVERIFY(mirror->front().tick <= mirror->back().tick && mirror->back().tick < recording->ticks());
    QVERIFY(content(handedIn_ / "report.csv").contains("mirror_time,"));
    QVERIFY(!content(handedIn_ / "report.csv").contains("mirror_time,,"));
}

void WindowFinishTest::theCommandLineGivesTheSameMark() {
    const fs::path out = folder_ / "by command";
    const test::ProgramRun run = test::runTactooth(
        {"assess", handedIn_ / "recording.ttsession", "--exercise", kExercise, "--out", out.string()});
    QVERIFY2(run.exitCode == 0 || run.exitCode == 1, run.err.c_str());
    QCOMPARE(json(out / "report.json")["mark"].toDouble(), mark_.toDouble());
    QCOMPARE(content(out / "report.csv"), content(handedIn_ / "report.csv"));
    const fs::path other = folder_ / "by tooth";
    const test::ProgramRun tooth =
        test::runTactooth({"assess", handedIn_ / "tooth.tactooth", "--exercise", kExercise, "--out", other.string()});
    QVERIFY2(tooth.exitCode == 0 || tooth.exitCode == 1, tooth.err.c_str());
    QCOMPARE(json(other / "report.json")["mark"].toDouble(), mark_.toDouble());
}

void WindowFinishTest::anErrorIsReplayedFromShortlyBeforeIt() {
    QVERIFY(select(true));
    const QStringList moment = list().currentItem()->text(3).section(' ', -1).split(':');
    const double at = 60 * moment[0].toDouble() + moment[1].toDouble();  // s, rounded down
    QTest::keyClick(&list(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(window_->replay().isActive(), kLoadPatience);
    QVERIFY(!report()->isVisible());
    QVERIFY(window_->replay().cursor().time() >= std::max(0.0, at - 2) - 1e-9);
    QVERIFY(window_->replay().cursor().time() <= at + 1);
    key(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(report() != nullptr && report()->isVisible(), kPatience);
    QVERIFY(window_->model().runner() == nullptr);  // the work has not gone on meanwhile
}

void WindowFinishTest::whatHasNoMomentIsNotReplayed() {
    QVERIFY(select(false));
    const auto* const replay = window_->findChild<QPushButton*>("reportReplay");
    QVERIFY(!replay->isEnabled());
    QVERIFY(replay->toolTip().contains("no single moment"));
    QVERIFY(select(true));
    QVERIFY(replay->isEnabled());
}

void WindowFinishTest::afterClosingTheTimeStandsStillUntilTheStudentCuts() {
    QTest::keyClick(report(), Qt::Key_Escape);
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(action().text(), QString("&Continue exercise"), kPatience);
    waitForSteps(2);
    const QString stopped = time();
    const double worked = window_->model().log().workSeconds();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().workSeconds() > worked + 1.5, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(time(), stopped, kPatience);
    key(Qt::Key_C);
    QVERIFY(!window_->exercise().isClockStopped());
    QTRY_VERIFY_WITH_TIMEOUT(time() != stopped, kPatience);
    key(Qt::Key_T);
}

void WindowFinishTest::continueLetsTheTimeGoOn() {
    QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
    finish();
    click("reportContinue");
    QTRY_VERIFY_WITH_TIMEOUT(report() == nullptr, kPatience);
    waitForTooth();
    QVERIFY(!window_->exercise().isClockStopped());
    QTRY_COMPARE_WITH_TIMEOUT(action().text(), QString("&Finish exercise"), kPatience);
}

void WindowFinishTest::againAsksBeforeCutsAreLost() {
    cutALittle();
    finish();
    const CutModel* const before = window_->model().tooth()->piece.get();
    click("reportAgain");
    QVERIFY(unsavedQuestion() != nullptr);
    answerUnsaved(QMessageBox::Cancel);
    QVERIFY(report() != nullptr && report()->isVisible());
    click("reportAgain");
    answerUnsaved(QMessageBox::Discard);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().tooth()->piece.get() != before, kLoadPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(report() == nullptr, kPatience);
    QCOMPARE(removed(), 0.0);
    QVERIFY(!window_->exercise().isClockStopped());
    QCOMPARE(window_->exercise().active(), builtinExercise(kExercise));
}

void WindowFinishTest::anExaminationEndsWithHandingInAlone() {
    window_->findChild<QAction*>("examination")->trigger();
    QVERIFY(window_->examination().isOn());
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().isSealing(), kPatience);
    cutALittle();
    QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
    key(Qt::Key_E, Qt::ControlModifier);
    auto* question = window_->findChild<QMessageBox*>("finishExamination");
    QVERIFY(question != nullptr);
    for (QAbstractButton* button : question->buttons()) {
        if (question->buttonRole(button) == QMessageBox::AcceptRole) QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(!window_->examination().isOn());
    handIn("Ren Mori");
    QVERIFY(report() == nullptr);
    QVERIFY(window_->findChild<QLabel*>("mark") == nullptr);
    QVERIFY(dismissMessage().contains("Ren Mori"));
    const auto recording = SessionRecording::open(handedIn_ / "recording.ttsession");
    QVERIFY(recording.has_value());
    const auto seal = checkRecordingSeal(*recording);
    QVERIFY(seal.has_value() && seal->isProof());
    QVERIFY(fs::file_size(handedIn_ / "report.pdf") > 0);
    waitForTooth();
}

void WindowFinishTest::withoutARecordingNothingIsReplayed() {
    window_->recordings().findChild<QAction*>("recordSessions")->trigger();
    QVERIFY(!window_->model().isRecording());
    startExercise();
    cutALittle();
    QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
    finish();
    const auto* const replay = window_->findChild<QPushButton*>("reportReplay");
    QVERIFY(!replay->isEnabled());
    QVERIFY(replay->toolTip().contains("no recording"));
    QVERIFY(!window_->finish().assessment()->report.strip.has_value());
    click("reportClose");
    waitForTooth();
}

void WindowFinishTest::savePictures(const QString& folder) {
    for (const char* language : {"en", "ja"}) {
        applyLanguage(*qApp, language);
        initTestCase();
        startExercise();
        window_->model().manipulator().setPressDepth(2);
        cutALittle();
        const auto save = [&](const char* name) {
            (void)waitForQuietPicture();
            const QString file = QString("%1/%2-%3.png").arg(folder, name, language);
            window_->screen()->grabWindow(0).save(file);
        };
        save("panel");
        action().trigger();
        QTRY_VERIFY_WITH_TIMEOUT(report() != nullptr && report()->isVisible(), kLoadPatience);
        save("report");
        applyColours(true);
        save("report-dark");
        click("reportHandIn");
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QDialog*>("handIn") != nullptr, kLoadPatience);
        save("hand-in-dark");
        applyColours(false);
        save("hand-in");
        closeWindow();
    }
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowFinishTest test;
    if (argc == 3 && QString(argv[1]) == "--pictures") return test.savePictures(argv[2]), 0;
    return QTest::qExec(&test, argc, argv);
}

#include "window_finish_test.moc"

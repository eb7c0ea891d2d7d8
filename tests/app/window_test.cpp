// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A session with the real window: real mouse and key events, the real runner, real files.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableWidget>
#include <ctime>
#include <fstream>

#include "app/gui/dialogs/open_tooth_dialog.h"
#include "app/gui/dialogs/welcome_dialog.h"
#include "app/gui/panels/elided_label.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "geometry/io/mesh_file.h"
#include "geometry/io/stl_writer.h"
#include "geometry/mesh/mesh_report.h"
#include "session/simulation/tooth_file.h"
#include "sound/sound_files.h"
#include "support/sanitizer.h"
#include "support/shapes.h"

namespace tactooth {

class WindowTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Saves a picture of the window in the middle of a cut.
    bool saveScreenshot(const QString& file);

private slots:
    void initTestCase();
    void aNewcomerTouchesTheToothWithinHalfAMinute();
    void theBuiltInMolarComesByItself();
    void whatIsSeenFirstIsSeenWhole();
    void theMouseTouchesTheToothAndTheMeterShowsIt();
    void pressingHarderGivesMoreForce();
    void theSpaceKeyIsThePedal();
    void aBurThatCannotCutSaysWhy();
    void aTouchingBurRemovesNothing();
    void aCuttingBurRemovesEnamel();
    void whatHappenedIsListedAndExported();
    void atRestNothingIsDrawnAndASpinningBurIs();
    void aWindowThatRestsIsSeldomComposed();
    void theCutToothIsExportedClosed();
    void anExportThatFailsSaysWhy();
    void theToothIsSavedAndUndoTakesBackACut();
    void resetPutsEverythingBack();
    void anotherBurIsTaken();
    void aToothIsOpenedFromAFile();
    void unusableFilesAreRefusedWithASentenceAndTheToothStays_data();
    void unusableFilesAreRefusedWithASentenceAndTheToothStays();
    void everyViewTurnsThePicture();
    void theMirrorCanBePutAway();
    void ownRecordingsArePlayedAndPutAway();
    void aRecordingThatCannotBeUsedIsRefusedWithASentence();
    void aToothOfTheWholeMouthIsChosenFromTheChart();
    void anotherWindowTakesOverTheSettings();
    void settingsThatMakeNoSenseChangeNothing();
    void cleanupTestCase();

private:
    void openInDialog(const QString& file);

    QElapsedTimer started_;
};

void WindowTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());  // the cache of teeth
    started_.start();
    openWindow();
}

/// A user who reads nothing takes the first of the choices and presses on the tooth.
void WindowTest::aNewcomerTouchesTheToothWithinHalfAMinute() {
    window_->welcome().open();
    auto* welcome = window_->findChild<WelcomeDialog*>();
    QTest::mouseClick(welcome->findChild<QPushButton*>("practise"), Qt::LeftButton);
    waitForTooth();
    pressBurOn(middle());
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
    QVERIFY2(test::isSanitized() || started_.elapsed() < 30000, qPrintable(QString::number(started_.elapsed())));
    liftBur(middle());
    QTRY_COMPARE_WITH_TIMEOUT(gauge("forceGauge"), 0.0, kPatience);
}

void WindowTest::theBuiltInMolarComesByItself() {
    waitForTooth();
    QVERIFY(window_->windowTitle().contains("molar"));
    QVERIFY(surface().base->mesh().triangles.size() > 10000);
}

/// At the default size of the window each panel that is in front first is visible as a whole, and so are the tabs below
/// the picture. A tab behind another one keeps an old size until it is in front.
void WindowTest::whatIsSeenFirstIsSeenWhole() {
    QCOMPARE(window_->size(), QSize(1400, 900));
    constexpr int kSoon = 10'000;  // ms
    const QByteArray before = window_->saveState();
    const QSize picture = view().size();
    for (const char* const name : {"Drill", "Force", "Look inside", "Exercise", "Real time", "Last ten seconds"}) {
        auto* dock = window_->findChild<QDockWidget*>(name);
        dock->raise();
        const auto* area = qobject_cast<QScrollArea*>(dock->widget());
        if (area == nullptr) continue;  // it takes any size
        QTRY_VERIFY2_WITH_TIMEOUT(area->verticalScrollBar()->maximum() == 0, name, kSoon);
    }
    window_->restoreState(before);
    QTRY_COMPARE_WITH_TIMEOUT(view().size(), picture, kSoon);
}

void WindowTest::theMouseTouchesTheToothAndTheMeterShowsIt() {
    QCOMPARE(gauge("forceGauge"), 0.0);
    pressBurOn(middle());
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.3, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
    liftBur(middle());
    QTRY_COMPARE_WITH_TIMEOUT(gauge("forceGauge"), 0.0, kPatience);
}

void WindowTest::pressingHarderGivesMoreForce() {
    auto* depth = window_->findChild<QDoubleSpinBox*>("pressDepth");
    auto* mode = window_->findChild<QComboBox*>("mouseMode");
    mode->setCurrentIndex(mode->findData(QString(kMouseByForce)));
    depth->setValue(0.4);
    pressBurOn(middle());
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    const auto pressed = [&] { return window_->model().log().newest().contact.depth; };
    // The slope below changes it a little: beside a ridge the bur lies on one side or on the other.
    QTRY_VERIFY2_WITH_TIMEOUT(std::abs(pressed() - 0.4) < 0.1, qPrintable(QString::number(pressed())), kPatience);
    const double light = std::max(gauge("forceGauge"), window_->model().log().newest().force.wrench.force.norm());
    for (int notch = 0; notch < 8; ++notch) {
        QWheelEvent wheel(middle(), view().mapToGlobal(middle()), {}, {0, 120}, Qt::LeftButton, {}, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(&view(), &wheel);
    }
    QCOMPARE(depth->value(), 1.2);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 1.5 * light, kPatience);
    liftBur(middle());
    depth->setValue(0.4);
    mode->setCurrentIndex(mode->findData(QString(kMouseToDepth)));
}

void WindowTest::theSpaceKeyIsThePedal() {
    key(Qt::Key_C);
    QTest::keyPress(window_.get(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") > 300, kPatience);
    QTest::keyRelease(window_.get(), Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 5, kPatience);
    key(Qt::Key_T);
}

void WindowTest::aBurThatCannotCutSaysWhy() {
    const auto* hint = window_->findChild<ElidedLabel*>("hint");
    auto* keepPedal = window_->findChild<QCheckBox*>("keepPedal");
    const QString usual = hint->text();
    key(Qt::Key_C);
    pressBurOn(middle());
    QTRY_VERIFY2_WITH_TIMEOUT(hint->text().contains("pedal (Space)"), qPrintable(hint->text()), kPatience);
    keepPedal->setChecked(true);
    QTRY_VERIFY2_WITH_TIMEOUT(!hint->text().contains("stands still"), qPrintable(hint->text()), kPatience);
    key(Qt::Key_T);
    QTRY_VERIFY2_WITH_TIMEOUT(hint->text().contains("Cut (C)"), qPrintable(hint->text()), kPatience);
    liftBur(middle());
    QTRY_COMPARE_WITH_TIMEOUT(hint->text(), usual, kPatience);
    keepPedal->setChecked(false);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 5, kPatience);
    key(Qt::Key_R, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
}

void WindowTest::aTouchingBurRemovesNothing() {
    window_->findChild<QCheckBox*>("keepPedal")->setChecked(true);
    pressBurOn(middle());
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);
    const double touched = window_->model().log().newest().time;
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().time > touched + 0.3, kPatience);
    liftBur(middle());
    QCOMPARE(removed(), 0.0);
}

/// Also checks the rate of surfaces: at least 20 a second on two cores. The processor time shows what the program would
/// reach with two cores of its own. A sanitizer takes more.
void WindowTest::aCuttingBurRemovesEnamel() {
    key(Qt::Key_C);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") > 300, kPatience);
    pressBurOn(middle());
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().runner()->feed().surfaceUpdates() > 0, kPatience);
    const std::uint64_t updatesBefore = window_->model().runner()->feed().surfaceUpdates();
    const std::clock_t processorBefore = std::clock();
    for (int i = 1; i <= 20; ++i) {
        QTest::mouseMove(&view(), middle() + QPoint(i, 0));
        const std::uint64_t now = window_->model().runner()->feed().surfaceUpdates();
        (void)QTest::qWaitFor([&] { return window_->model().runner()->feed().surfaceUpdates() > now; }, 2000);
    }
    QTRY_VERIFY_WITH_TIMEOUT(removed() > 0.05, kPatience);
    const auto updates = static_cast<double>(window_->model().runner()->feed().surfaceUpdates() - updatesBefore);
    const double onTwoCores = static_cast<double>(std::clock() - processorBefore) / CLOCKS_PER_SEC / 2;
    QVERIFY2(test::isSanitized() || updates > 20 * onTwoCores,
             qPrintable(QString("%1 in %2 s").arg(updates).arg(onTwoCores)));
    liftBur(middle());
    key(Qt::Key_T);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QLabel*>("removed")->text().contains("enamel"), kPatience);
}

void WindowTest::whatHappenedIsListedAndExported() {
    auto* events = window_->findChild<QTableWidget*>("events");
    QTRY_VERIFY_WITH_TIMEOUT(events->rowCount() > 0, kPatience);
    QCOMPARE(events->item(0, 1)->text(), QString("first contact"));
    window_->records().exportEventsTo(QString::fromStdString((folder_ / "events.csv").string()));
    waitForFiles();
    std::ifstream table(folder_ / "events.csv");
    std::string head, first;
    std::getline(table, head);
    std::getline(table, first);
    QCOMPARE(head, std::string("t,event,x,y,z,taken_back"));  // the tooth was put back before
    QVERIFY(first.find(",first contact,") != std::string::npos);
    const Vec3 place = window_->model().log().events().all().front().place;
    emit events->itemActivated(events->item(0, 1));
    const auto pixel = project(view().camera(), {200, 100}, place);
    QVERIFY(pixel && (*pixel - Vec2(100, 50)).norm() < 0.01);
    view().resetView();
    window_->records().exportEventsTo("/nowhere/events.csv");
    QVERIFY(messageAfterFiles().contains("/nowhere"));
}

void WindowTest::atRestNothingIsDrawnAndASpinningBurIs() {
    auto* pedal = window_->findChild<QCheckBox*>("keepPedal");
    pedal->setChecked(false);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 1, kPatience);
    QVERIFY(waitForQuietPicture());
    key(Qt::Key_C);
    pedal->setChecked(true);
    const std::uint64_t before = view().pictures();
    QTRY_VERIFY_WITH_TIMEOUT(view().pictures() > before + 3, kPatience);
    key(Qt::Key_T);
}

/// The clock of the exercise runs on behind its tab, and the status line has a meter.
void WindowTest::aWindowThatRestsIsSeldomComposed() {
    QVERIFY(window_->model().log().workSeconds() > 0);
    auto* pedal = window_->findChild<QCheckBox*>("keepPedal");
    pedal->setChecked(false);
    QTRY_VERIFY_WITH_TIMEOUT(gauge("speedGauge") < 1, kPatience);
    waitForRest();
    // Their absence has no condition to wait for. A busy machine changes the status line, so one quiet time is
    // enough: a window that keeps drawing has none.
    constexpr int kTries = 20;
    int compositions = 2;
    for (int i = 0; i < kTries && compositions > 1; ++i) {
        QSignalSpy composed(&view(), &QOpenGLWidget::frameSwapped);
        QTest::qWait(2000);
        compositions = static_cast<int>(composed.count());
    }
    QVERIFY2(compositions <= 1, qPrintable(QString::number(compositions)));
    pedal->setChecked(true);
}

void WindowTest::theCutToothIsExportedClosed() {
    waitForCarving();
    const QString file = QString::fromStdString((folder_ / "cut.stl").string());
    window_->teeth().exportTooth(file);
    waitForFiles();
    const Expected<TriangleMesh> cut = loadMesh(file.toStdString());
    QVERIFY(cut.has_value());
    const MeshReport report = reportOn(*cut);
    QVERIFY(report.watertight());
    const double whole = reportOn(surface().base->mesh()).signedVolume;
    QVERIFY(std::abs(whole - report.signedVolume - removed()) < 0.02 * removed() + 0.01);
    QVERIFY(cut->triangles != surface().base->mesh().triangles);
}

void WindowTest::anExportThatFailsSaysWhy() {
    window_->teeth().exportTooth("/nowhere/cut.stl");
    QVERIFY(messageAfterFiles().contains("/nowhere"));
}

void WindowTest::theToothIsSavedAndUndoTakesBackACut() {
    const double cut = removed();
    QVERIFY(cut > 0);
    const auto file = folder_ / "cut.tactooth";
    window_->teeth().saveTooth(QString::fromStdString(file.string()));
    waitForFiles();
    const Expected<OpenedTooth> saved = openTooth(file);
    QVERIFY2(saved.has_value(), saved ? "" : saved.error().message().c_str());
    QCOMPARE(total(saved->piece->removed()), cut);
    QVERIFY(!saved->provenance.empty());
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(removed() < cut, kPatience);
}

void WindowTest::resetPutsEverythingBack() {
    key(Qt::Key_R, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), 0.0, kPatience);
    QCOMPARE(visibleMesh(surface()).mesh.triangles.size(), surface().base->mesh().triangles.size());
    window_->findChild<QCheckBox*>("keepPedal")->setChecked(false);
}

void WindowTest::anotherBurIsTaken() {
    const std::string before = window_->model().bur()->name;
    auto* burs = window_->findChild<QComboBox*>("burs");
    burs->setFocus();
    QTest::keyClick(burs, Qt::Key_Down);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().bur()->name != before, kPatience);
    waitForTooth();
}

void WindowTest::openInDialog(const QString& file) {
    key(Qt::Key_O, Qt::ControlModifier);
    auto* dialog = window_->findChild<OpenToothDialog*>();
    QVERIFY(dialog != nullptr);
    auto* line = dialog->findChild<QLineEdit*>("outerSurface");
    QTest::keyClicks(line, file);
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<OpenToothDialog*>() == nullptr, kPatience);
}

void WindowTest::aToothIsOpenedFromAFile() {
    const auto file = folder_ / "ball.stl";
    QVERIFY(writeStl(test::sphere(Vec3(20, 0, 0), 5, 40, 30), file).has_value());
    openInDialog(QString::fromStdString(file.string()));
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->name, std::string("ball.stl"), kLoadPatience);
    waitForTooth();
    QCOMPARE(dismissMessage(), QString());
    pressBurOn(middle() + QPoint(0, 40));
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    liftBur(middle());
}

void WindowTest::unusableFilesAreRefusedWithASentenceAndTheToothStays_data() {
    QTest::addColumn<QString>("file");
    const auto add = [this](const char* name, const std::string& content) {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        QTest::newRow(name) << QString::fromStdString((folder_ / name).string());
    };
    add("garbage.stl", "this is no surface at all");
    add("empty.stl", "");
    add("truncated.stl", std::string(80, ' ') + std::string("\x10\x27\0\0", 4) + std::string(75, 'x'));
    const auto open = folder_ / "open.stl";
    TriangleMesh box = test::box(Vec3::Zero(), Vec3::Ones());
    box.triangles.pop_back();
    QVERIFY(writeStl(box, open).has_value());
    QTest::newRow("open surface") << QString::fromStdString(open.string());
    QTest::newRow("directory") << QString::fromStdString(folder_.path().string());
    QTest::newRow("missing") << QString::fromStdString((folder_ / "missing.stl").string());
}

void WindowTest::unusableFilesAreRefusedWithASentenceAndTheToothStays() {
    QFETCH(QString, file);
    const Surface* before = &surface();
    openInDialog(file);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    const QString message = dismissMessage();
    QVERIFY2(message.contains(file), qPrintable(message));
    QCOMPARE(&surface(), before);
    QCOMPARE(window_->model().tooth()->name, std::string("ball.stl"));
}

void WindowTest::everyViewTurnsThePicture() {
    QImage last = view().grabFramebuffer();
    for (const Qt::Key view_ : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_0}) {
        key(view_);
        const QImage now = view().grabFramebuffer();
        QVERIFY(now != last);
        last = now;
    }
}

void WindowTest::theMirrorCanBePutAway() {
    const QImage with = view().grabFramebuffer();
    key(Qt::Key_M);
    QVERIFY(view().grabFramebuffer() != with);
    key(Qt::Key_M);
}

void WindowTest::ownRecordingsArePlayedAndPutAway() {
    test::writeTone(folder_ / "mine.wav", 5000, 0.3);
    window_->sounds().open(QString::fromStdString(folder_ / "mine.wav"));
    auto* sounds = window_->findChild<QComboBox*>("sounds");
    QTRY_COMPARE_WITH_TIMEOUT(sounds->currentText(), QString("mine.wav"), kPatience);
    QCOMPARE(window_->settings().ownSounds, (folder_ / "mine.wav").string());
    sounds->setCurrentIndex(0);
    emit sounds->activated(0);
    QCOMPARE(sounds->currentText(), QString("Synthesised"));
    QVERIFY(window_->settings().ownSounds.empty());
    QTRY_COMPARE_WITH_TIMEOUT(sound_->status(), SoundStatus::Playing, kPatience);
}

void WindowTest::aRecordingThatCannotBeUsedIsRefusedWithASentence() {
    std::ofstream(folder_ / "noise.wav") << "not a sound";
    window_->sounds().open(QString::fromStdString(folder_ / "noise.wav"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    const QString said = dismissMessage();
    QVERIFY2(said.contains("noise.wav: this is neither WAV, FLAC nor Ogg"), qPrintable(said));
    QCOMPARE(window_->findChild<QComboBox*>("sounds")->currentText(), QString("Synthesised"));
}

void WindowTest::aToothOfTheWholeMouthIsChosenFromTheChart() {
    key(Qt::Key_T, Qt::ControlModifier);
    auto* tooth = window_->findChild<QAbstractButton*>("tooth36");
    QVERIFY(tooth != nullptr);
    tooth->click();
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->name, std::string("36"), kLoadPatience);
    waitForTooth();
    constexpr std::size_t kUncut = 29 + 2;  // teeth and gums: all bodies but both neighbours, which can be cut
    QCOMPARE(touchableSurface(window_->model())->patches.size(), kUncut);
    QVERIFY(surface().patches.empty());
    pressBurOn(middle() + QPoint(0, 40));
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    liftBur(middle());
}

void WindowTest::anotherWindowTakesOverTheSettings() {
    WindowSettings settings = window_->settings();
    settings.bur = "58";
    settings.spindle = spindlePresets().back().name;
    settings.showsMirror = false;
    settings.force = {false, 0.8, 0.01, 1.5, 2};
    settings.sound = {.motor = 0.2, .cutting = 0.4, .master = 0.6, .muted = true, .environment = 0.3};
    settings.headphones = true;
    settings.folder = "/somewhere";
    MainWindow other(*sound_);
    other.apply(settings);
    const WindowSettings taken = other.settings();
    QCOMPARE(taken.bur, settings.bur);
    QCOMPARE(taken.spindle, settings.spindle);
    QCOMPARE(taken.showsMirror, false);
    QCOMPARE(taken.showsTurbine, settings.showsTurbine);
    QVERIFY(taken.force == settings.force);
    QCOMPARE(taken.sound.motor, 0.2);
    QCOMPARE(taken.sound.cutting, 0.4);
    QCOMPARE(taken.sound.master, 0.6);
    QVERIFY(taken.sound.muted);
    QCOMPARE(taken.sound.environment, 0.3);
    QVERIFY(taken.headphones);
    QCOMPARE(taken.folder, settings.folder);
    QCOMPARE(other.size(), window_->size());
    QCOMPARE(other.model().controls.forceScale, 1.5);
    QCOMPARE(other.model().haptics().spindle.name, settings.spindle);
}

void WindowTest::settingsThatMakeNoSenseChangeNothing() {
    MainWindow other(*sound_);
    const WindowSettings before = other.settings();
    WindowSettings senseless = before;
    senseless.geometry = "?";
    senseless.docks = "AAAA";
    senseless.bur = "no such bur";
    senseless.spindle = "steam";
    other.apply(senseless);
    QCOMPARE(other.settings().geometry, before.geometry);
    QCOMPARE(other.settings().docks, before.docks);
    QCOMPARE(other.settings().bur, before.bur);
    QCOMPARE(other.settings().spindle, before.spindle);
}

void WindowTest::cleanupTestCase() { closeWindow(); }

bool WindowTest::saveScreenshot(const QString& file) {
    openWindow();
    waitForTooth();
    window_->findChild<QCheckBox*>("keepPedal")->setChecked(true);
    key(Qt::Key_C);
    (void)QTest::qWaitFor([this] { return gauge("speedGauge") > 300; }, 5000);
    const QPoint start = middle() + QPoint(-18, 78);
    pressBurOn(start);
    QElapsedTimer since;
    since.start();
    for (double seconds = 0; seconds < 4; seconds = static_cast<double>(since.elapsed()) / 1000) {
        QTest::mouseMove(&view(), start + QPoint(static_cast<int>(10 * seconds), static_cast<int>(-3 * seconds)));
        QTest::qWait(50);
    }
    const bool saved = window_->grab().save(file);
    cleanupTestCase();
    return saved;
}

}  // namespace tactooth

/// `window_tests --screenshot FILE.png` writes a picture of the window instead of testing it.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--screenshot") return test.saveScreenshot(arguments.value(2)) ? 0 : 1;
    return QTest::qExec(&test, argc, argv);
}

#include "window_test.moc"

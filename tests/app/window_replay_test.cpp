// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A recorded session in the window: opened, played, scrubbed, compared, commented, and left again.
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QStackedWidget>
#include <QToolButton>
#include <fstream>

#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/replay/replay_bar.h"
#include "app/gui/replay/replay_panel.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "recording/recorded_touches.h"
#include "session/hands/instrument_poses.h"
#include "session/track/replay_comments.h"
#include "track/recorded_strokes.h"

namespace tactooth {
namespace {

/// Share of the pixels that differ visibly.
double differingShare(const QImage& a, const QImage& b) {
    constexpr int kVisible = 24;  // of 255
    int differing = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            differing += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue()) >
                                 3 * kVisible
                             ? 1
                             : 0;
        }
    }
    return static_cast<double>(differing) / (a.width() * a.height());
}

/// A mirror behind the block that shows its side away from the eye; away and back, and then a small one.
MirrorSight heldAfter(int ticks) {
    const Vec3 toEye = directionToEye(dentistView(1));
    const Pose behind = parkedMirror(Box3(Vec3(-1.5, -1.5, -3), Vec3(1.5, 1.5, 0)), toEye, 1);
    if (ticks < 500) return MirrorSight::of(behind, makeMirror(22).disc.radius, 40 * toEye);
    if (ticks < 1000) return {};
    return MirrorSight::of({behind.position - Vec3(2, 0, 0), behind.rotation}, makeMirror(18).disc.radius, 40 * toEye);
}

}  // namespace

class WindowReplayTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at: with the mirror, without it, and with the small one.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void aDroppedRecordingIsReplayed();
    void itPlaysAndPauses();
    void theSliderShowsTheToothOfItsTime();
    void eventsAreJumpedToAndTicksAreSteppedThrough();
    void thePlotsFollowTheCursor();
    void nothingCanBeCutMeanwhile();
    void aCommentIsPinnedToAMomentBesideTheRecording();
    void anotherRecordingIsShownAsAGhost();
    void theBenchIsAsItWasAfterwards();
    void aFileThatIsNoRecordingHasASentence();
    void theMirrorIsShownWhereItWasHeld();
    void itBeginsFromTheEyeOfTheRecording();
    void aMirrorOfASizeThatNoneHasIsNotShown();
    void theSwitchOfTheMirrorHidesItInTheReplay();
    void anOpenedToothEndsTheReplay();
    void cleanupTestCase();

private:
    [[nodiscard]] ReplayController& replay() const { return window_->replay(); }
    [[nodiscard]] QString recording(const char* name) const { return QString::fromStdString(folder_ / name); }
    template <class Widget>
    [[nodiscard]] Widget& part(const char* name) const {
        return *window_->findChild<Widget*>(name);
    }
    void click(const char* name) const { QTest::mouseClick(&part<QToolButton>(name), Qt::LeftButton); }
    void open(const QString& file) {
        window_->teeth().openFile(file);
        QTRY_VERIFY_WITH_TIMEOUT(replay().isActive() && !replay().isLoading(), kLoadPatience);
        QTRY_VERIFY_WITH_TIMEOUT(replay().source()->track()->isFinished(), kLoadPatience);
    }
    /// The tooth in the picture is that of the cursor's moment. It asks for it first: the next picture may not have
    /// been drawn yet.
    void waitForTooth() const {
        (void)shown();
        QTRY_VERIFY_WITH_TIMEOUT(replay().source()->isToothThere(), kPatience);
    }
    [[nodiscard]] SceneContents shown() const { return replay().source()->contentsAt(replay().cursor().moment(), {}); }

    /// As soon as it shows the cursor's moment and rests.
    [[nodiscard]] QImage picture() const {
        auto& view = part<ToothView>("replayView");
        const auto isThere = [&] {
            (void)shown();
            return replay().source()->isToothThere() && view.isAtRest();
        };
        if (!QTest::qWaitFor(isThere, kPatience)) return {};
        return view.grabFramebuffer();
    }

    double benchRemoved_ = 0;
    std::shared_ptr<const Surface> bench_;
};

void WindowReplayTest::initTestCase() {
    (void)test::RecordedStrokes{.seconds = 4, .resetAt = 99}.writeTo(folder_ / "a.ttsession");
    (void)test::RecordedStrokes{.seconds = 3, .seed = 2, .resetAt = 99}.writeTo(folder_ / "b.ttsession");
    (void)test::recordTouches(folder_ / "mirror.ttsession", [](SessionRecorder& recorder, int ticks) {
        recorder.noteMirror(heldAfter(ticks), test::atTick(ticks));
    });
    openWindow();
    WindowSession::waitForTooth();
    benchRemoved_ = removed();
    bench_ = window_->model().runner()->feed().surface();
}

void WindowReplayTest::cleanupTestCase() { closeWindow(); }

void WindowReplayTest::aDroppedRecordingIsReplayed() {
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(recording("a.ttsession"))});
    QDragEnterEvent enter(middle(), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);  // without it Qt drops nothing
    QDropEvent drop(QPointF(middle()), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(replay().isActive(), kLoadPatience);
    QTRY_VERIFY_WITH_TIMEOUT(part<QWidget>("replayPanel").isVisible(), kPatience);
    QVERIFY(!view().isVisible());
    QVERIFY(part<QLabel>("replaySign").text().contains("Replay"));
    QVERIFY(part<QLabel>("replaySign").text().contains("a.ttsession"));
    QTRY_VERIFY_WITH_TIMEOUT(part<ToothView>("replayView").pictures() > 0, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(replay().source()->track()->isFinished(), kLoadPatience);
    QVERIFY(!replay().source()->track()->differsAt());
}

void WindowReplayTest::itPlaysAndPauses() {
    if (replay().cursor().isPlaying()) click("replayPlay");
    QVERIFY(!replay().cursor().isPlaying());
    replay().cursor().jumpTo(0);
    key(Qt::Key_Space);
    QVERIFY(replay().cursor().isPlaying());
    QTRY_VERIFY_WITH_TIMEOUT(replay().cursor().time() > 0.3, kPatience);
    auto& speeds = part<QComboBox>("replaySpeed");
    speeds.setCurrentIndex(speeds.count() - 1);
    emit speeds.activated(speeds.count() - 1);
    QCOMPARE(replay().cursor().speed(), 16.0);
    QTRY_VERIFY_WITH_TIMEOUT(!replay().cursor().isPlaying(), kPatience);  // the end
    QCOMPARE(replay().cursor().time(), replay().source()->track()->seconds());
    QTRY_COMPARE_WITH_TIMEOUT(part<QToolButton>("replayPlay").text(), QString("Play"), kPatience);
}

void WindowReplayTest::theSliderShowsTheToothOfItsTime() {
    auto& slider = part<ReplaySlider>("replayTime");
    slider.setValue(3000);
    QVERIFY(std::abs(replay().cursor().time() - 3) < 1e-9);
    waitForTooth();
    const auto late = shown();
    slider.setValue(500);
    waitForTooth();
    const auto early = shown();
    QVERIFY(shown().tool.has_value());
    QVERIFY(late.tooth != early.tooth);
    QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(slider.width() / 2, slider.height() / 2));
    QVERIFY2(std::abs(replay().cursor().time() - 2) < 0.1, qPrintable(QString::number(replay().cursor().time())));
    QTRY_VERIFY_WITH_TIMEOUT(part<QLabel>("replayClock").text().startsWith("0:0"), kPatience);
}

void WindowReplayTest::eventsAreJumpedToAndTicksAreSteppedThrough() {
    for (const char* name : {"replayPrevious", "replayBack", "replayOn", "replayNext"})
        QVERIFY2(!part<QToolButton>(name).icon().isNull(), name);  // not every font has signs for them
    QTRY_VERIFY_WITH_TIMEOUT(part<ReplayBar>("replayBar").marks().size() > 3, kPatience);
    replay().cursor().jumpTo(1.5);
    click("replayNext");
    const double next = replay().cursor().time();
    QVERIFY(next > 1.5);
    click("replayPrevious");
    QVERIFY(replay().cursor().time() < 1.5);
    QTRY_VERIFY_WITH_TIMEOUT(!part<QLabel>("replayNote").text().isEmpty(), kPatience);
    const std::uint64_t moment = replay().cursor().moment();
    key(Qt::Key_Period);
    QCOMPARE(replay().cursor().moment(), moment + 1);
    key(Qt::Key_Comma);
    QCOMPARE(replay().cursor().moment(), moment);
}

void WindowReplayTest::thePlotsFollowTheCursor() {
    const auto& plots = *window_->findChild<PlotPanel*>();
    for (const double time : {3.5, 1.0}) {
        replay().cursor().jumpTo(time);
        QTRY_VERIFY_WITH_TIMEOUT(
            !plots.shown().points().empty() && std::abs(plots.shown().points().back().time - time) < 0.2, kPatience);
    }
}

void WindowReplayTest::nothingCanBeCutMeanwhile() {
    QVERIFY(!window_->findChild<DrillBar*>()->isEnabled());
    QVERIFY(window_->model().runner() == nullptr);  // no device pushes against a tooth that nobody sees
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_R, Qt::ControlModifier);
    const OrbitCamera before = part<ToothView>("replayView").orbitCamera();
    const QPoint centre = part<ToothView>("replayView").rect().center();
    QTest::mousePress(&part<ToothView>("replayView"), Qt::LeftButton, {}, centre);
    QTest::mouseMove(&part<ToothView>("replayView"), centre + QPoint(60, 20));
    QTRY_VERIFY_WITH_TIMEOUT(
        part<ToothView>("replayView").orbitCamera().direction().azimuth != before.direction().azimuth, kPatience);
    QTest::mouseRelease(&part<ToothView>("replayView"), Qt::LeftButton, {}, centre + QPoint(60, 20));
}

void WindowReplayTest::aCommentIsPinnedToAMomentBesideTheRecording() {
    replay().cursor().jumpTo(2.25);
    const auto bytes = std::filesystem::file_size(folder_ / "a.ttsession");
    click("replayComment");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QInputDialog*>("replayCommentText") != nullptr, kPatience);
    auto* dialog = window_->findChild<QInputDialog*>("replayCommentText");
    dialog->setTextValue("too steep");
    dialog->accept();
    QTRY_VERIFY_WITH_TIMEOUT(part<QLabel>("replayNote").text().contains("too steep"), kPatience);
    const auto comments = ReplayComments::open(folder_ / "a.ttsession");
    QVERIFY(comments && comments->all().size() == 1);
    QCOMPARE(comments->all().front(), (ReplayComment{2.25, "too steep"}));
    QCOMPARE(std::filesystem::file_size(folder_ / "a.ttsession"), bytes);
    replay().cursor().jumpTo(0.5);
    auto& menu = part<QMenu>("replayComments");
    emit menu.aboutToShow();
    QVERIFY(menu.actions().front()->text().contains("too steep"));
    menu.actions().front()->trigger();
    QCOMPARE(replay().cursor().time(), 2.25);
    QTRY_VERIFY_WITH_TIMEOUT(part<QLabel>("replayNote").text().contains("too steep"), kPatience);
    emit menu.aboutToShow();
    menu.actions().back()->trigger();
    QVERIFY(ReplayComments::open(folder_ / "a.ttsession").value().all().empty());
}

void WindowReplayTest::anotherRecordingIsShownAsAGhost() {
    replay().comparison().open(recording("b.ttsession"), ReplayComparison::Mode::Ghost);
    QTRY_VERIFY_WITH_TIMEOUT(replay().comparison().isGhost(), kLoadPatience);
    QTRY_VERIFY_WITH_TIMEOUT(part<QToolButton>("replayCompare").isChecked(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(replay().comparison().source()->track()->isFinished(), kLoadPatience);
    replay().cursor().jumpTo(2);
    const std::uint64_t before = part<ToothView>("replayView").pictures();
    QTRY_VERIFY_WITH_TIMEOUT(part<ToothView>("replayView").pictures() > before, kPatience);
    click("replayCompare");
    QVERIFY(replay().comparison().source() == nullptr);
}

void WindowReplayTest::theBenchIsAsItWasAfterwards() {
    key(Qt::Key_Escape);
    QVERIFY(!replay().isActive());
    QTRY_VERIFY_WITH_TIMEOUT(view().isVisible() && window_->model().runner() != nullptr, kPatience);
    QVERIFY(window_->findChild<DrillBar*>()->isEnabled());
    QVERIFY(window_->model().runner()->feed().surface() == bench_);
    QCOMPARE(removed(), benchRemoved_);
    pressBurOn(middle());
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().log().newest().contact.triangles > 0, kPatience);  // it can be felt again
    liftBur(middle());
}

void WindowReplayTest::aFileThatIsNoRecordingHasASentence() {
    std::ofstream(folder_ / "text.ttsession") << "no recording";
    window_->teeth().openFile(recording("text.ttsession"));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    QVERIFY(dismissMessage().contains("text.ttsession"));
    QVERIFY(!replay().isActive());
}

void WindowReplayTest::theMirrorIsShownWhereItWasHeld() {
    open(recording("mirror.ttsession"));
    replay().cursor().setPlaying(false);
    for (const std::uint64_t moment : {1, 499, 500, 999, 1000, 1500}) {
        replay().cursor().jumpTo(replay().source()->track()->tickBefore(moment).time);
        QCOMPARE(replay().cursor().moment(), moment);
        const MirrorSight held = heldAfter(static_cast<int>(moment));
        const auto mirror = shown().mirror;
        QCOMPARE(mirror.has_value(), held.isShown);
        if (!mirror) continue;
        QCOMPARE(mirror->mirrorInTooth.position, held.mirror().position);
        QCOMPARE(mirror->mirrorInTooth.rotation.coeffs(), held.mirror().rotation.coeffs());
        // The recording rounds to a 4096th of a millimetre.
        const MirrorDisc disc = makeMirror(moment < 500 ? 22 : 18).disc;
        QVERIFY(std::abs(mirror->disc.radius - disc.radius) < 1.0 / 4096);
        QVERIFY(std::abs(boundingBox(*mirror->mesh).sizes().y() / 2 - (moment < 500 ? 11 : 9)) < 0.001);
    }
}

/// In a mirror another eye sees something else.
void WindowReplayTest::itBeginsFromTheEyeOfTheRecording() {
    const Vec3 eye = part<ToothView>("replayView").orbitCamera().camera().cameraInWorld.position;
    QVERIFY2((eye - heldAfter(0).eyePlace()).norm() < 1e-6, qPrintable(QString::number(eye.norm())));
}

/// A damaged file may say anything.
void WindowReplayTest::aMirrorOfASizeThatNoneHasIsNotShown() {
    MirrorSight sight = heldAfter(0);
    for (const double radius : {0.0, 1.0, 4.0, 19.5, 99.0, 1e6}) {
        sight.radius = std::llround(4096 * radius);
        QVERIFY(!ReplayMirror().at(sight));
    }
    for (const double radius : {4.5, 10.25, 19.0}) {
        sight.radius = std::llround(4096 * radius);
        const auto shown = ReplayMirror().at(sight);
        QVERIFY(shown.has_value());
        QCOMPARE(shown->disc.radius, radius);
    }
}

/// Two moments at which the bur is at nearly the same place, one with the mirror and one without.
void WindowReplayTest::theSwitchOfTheMirrorHidesItInTheReplay() {
    const auto at = [this](double time) {
        replay().cursor().jumpTo(time);
        return picture();
    };
    const QImage without = at(0.8), with = at(0.2);
    QVERIFY2(differingShare(with, without) > 0.1, qPrintable(QString::number(differingShare(with, without))));
    key(Qt::Key_M);
    const QImage hidden = picture();
    QVERIFY2(differingShare(hidden, without) < 0.02, qPrintable(QString::number(differingShare(hidden, without))));
    key(Qt::Key_M);
    QVERIFY(differingShare(picture(), with) < 0.001);
}

void WindowReplayTest::anOpenedToothEndsTheReplay() {
    open(recording("b.ttsession"));
    window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]);
    QTRY_VERIFY_WITH_TIMEOUT(!replay().isActive(), kLoadPatience);
    WindowSession::waitForTooth();
    QVERIFY(view().isVisible());
}

void WindowReplayTest::savePictures(const QString& folder) {
    initTestCase();
    open(recording("mirror.ttsession"));
    replay().cursor().setPlaying(false);
    for (const double time : {0.2, 0.8, 1.2}) {
        replay().cursor().jumpTo(time);
        (void)picture();
        window_->grab().save(QString("%1/replay-mirror-%2.png").arg(folder).arg(time));
    }
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_replay_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowReplayTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_replay_test.moc"

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two recorded sessions in pictures side by side: the same time, the same eye, and the usual window afterwards.
#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineSeries>
#include <QMimeData>
#include <QToolButton>
#include <algorithm>
#include <fstream>

#include "app/gui/panels/plot_colours.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/replay/replay_bar.h"
#include "app/gui/replay/replay_panel.h"
#include "app/gui/scene/view_cube.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "track/recorded_strokes.h"

namespace tactooth {
namespace {

constexpr int kVisible = 24;  // of 255: a difference of colour that the eye sees

/// Share of the pixels that differ visibly.
double differingShare(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return 1;
    int differing = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            const int most =
                std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
            differing += most > kVisible ? 1 : 0;
        }
    }
    return static_cast<double>(differing) / (a.width() * a.height());
}

/// Time of the first contact, found tick by tick.
double firstContact(const SessionTrack& track) {
    double time = -1;
    track.forEachTick(0, track.ticks(), [&](const TrackTick& tick) {
        if (time < 0 && tick.contacts > 0) time = tick.time;
    });
    return time;
}

}  // namespace

class WindowSideBySideTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void theButtonAsksForTheOtherRecording();
    void thePicturesShowDifferentTeeth();
    void theSameRecordingLooksTheSame();
    void scrubbingMovesBoth();
    void theCameraTurnsBoth();
    void bothBeginAtTheirFirstTouchUntilOneIsShifted();
    void theTimeLineReachesTheEndOfTheLongerOne();
    void thePlotsShowBothInTwoColours();
    void theSameButtonBringsTheUsualWindowBack();
    void theChoiceIsRemembered();
    void aGhostMovesIntoAPictureOfItsOwnAndBack();
    void closingTheFirstLeavesTheOther();
    void twoRecordingsAreDroppedTogether();
    void aFileThatIsNoRecordingChangesNothing();
    void leavingTheReplayClosesBoth();
    void cleanupTestCase();

public:
    void savePictures(const QString& folder, QString first, QString other);

private:
    [[nodiscard]] ReplayController& replay() const { return window_->replay(); }
    [[nodiscard]] ReplayComparison& comparison() const { return replay().comparison(); }
    [[nodiscard]] QString recording(const char* name) const { return QString::fromStdString(folder_ / name); }
    template <class Widget>
    [[nodiscard]] Widget& part(const char* name) const {
        return *window_->findChild<Widget*>(name);
    }
    [[nodiscard]] ToothView& first() const { return part<ToothView>("replayView"); }
    [[nodiscard]] ToothView* other() const { return window_->findChild<ToothView*>("replayOtherView"); }
    void click(const char* name) const { QTest::mouseClick(&part<QToolButton>(name), Qt::LeftButton); }
    void openFirst(const QString& file) {
        window_->teeth().openFile(file);
        QTRY_VERIFY_WITH_TIMEOUT(replay().isActive() && !replay().isLoading(), kLoadPatience);
        QTRY_VERIFY_WITH_TIMEOUT(replay().source()->track()->isFinished(), kLoadPatience);
        replay().cursor().setPlaying(false);
    }
    void openBeside(const QString& file) {
        comparison().open(file, ReplayComparison::Mode::SideBySide);
        waitForOther();
    }
    void waitForOther() const {
        QTRY_VERIFY_WITH_TIMEOUT(comparison().source() != nullptr, kLoadPatience);
        QTRY_VERIFY_WITH_TIMEOUT(comparison().source()->track()->isFinished(), kLoadPatience);
        replay().cursor().setPlaying(false);
    }
    /// Both pictures show the cursor's moment with full quality. It asks for the teeth first: the next pictures may not
    /// have been drawn yet.
    void waitForPictures() const {
        (void)replay().source()->contentsAt(replay().cursor().moment(), {});
        (void)comparison().source()->contentsAt(replay().cursor().otherMoment(), {});
        const auto isThere = [this] {
            return replay().source()->isToothThere() && comparison().source()->isToothThere() && first().isAtRest() &&
                   other()->isAtRest();
        };
        QTRY_VERIFY_WITH_TIMEOUT(isThere(), kPatience);
    }
    void drag(ToothView& view) const {
        const QPoint centre = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, centre);
        QTest::mouseMove(&view, centre + QPoint(40, 15));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, centre + QPoint(40, 15));
    }
    [[nodiscard]] bool looksFromOnePlace() const {
        const OrbitCamera a = first().orbitCamera(), b = other()->orbitCamera();
        return a.direction().azimuth == b.direction().azimuth && a.direction().elevation == b.direction().elevation &&
               a.distance() == b.distance() && a.target() == b.target();
    }
    [[nodiscard]] bool isUsualWindow() const {
        return other() == nullptr && comparison().source() == nullptr && !part<QLabel>("replayViewClock").isVisible() &&
               !part<QDoubleSpinBox>("replayShift").isVisible() && !comparison().sideBySideAction().isChecked();
    }
};

void WindowSideBySideTest::initTestCase() {
    (void)test::RecordedStrokes{.seconds = 3, .resetAt = 99}.writeTo(folder_ / "expert.ttsession");
    (void)test::RecordedStrokes{.seconds = 4, .seed = 2, .resetAt = 99}.writeTo(folder_ / "student.ttsession");
    openWindow();
    waitForTooth();
}

void WindowSideBySideTest::cleanupTestCase() { closeWindow(); }

void WindowSideBySideTest::theButtonAsksForTheOtherRecording() {
    QVERIFY(!comparison().sideBySideAction().isEnabled());  // there is nothing to compare with
    openFirst(recording("expert.ttsession"));
    QVERIFY(comparison().sideBySideAction().isEnabled());
    QVERIFY(isUsualWindow());
    click("replaySideBySideButton");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    QVERIFY(!comparison().sideBySideAction().isChecked());  // not yet
    auto* dialog = window_->findChild<QFileDialog*>();
    dialog->selectFile(recording("student.ttsession"));
    QMetaObject::invokeMethod(dialog, "accept");
    waitForOther();
    QVERIFY(comparison().sideBySideAction().isChecked());
    QVERIFY(other() != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(other()->isVisible() && first().isVisible(), kPatience);
    QVERIFY(part<QLabel>("replayViewTitle").text().contains("expert.ttsession"));
    QVERIFY(part<QLabel>("replayOtherViewTitle").text().contains("student.ttsession"));
    QTRY_COMPARE_WITH_TIMEOUT(first().size(), other()->size(), kPatience);
    QVERIFY(first().mapTo(window_.get(), QPoint()).x() < other()->mapTo(window_.get(), QPoint()).x());
}

void WindowSideBySideTest::thePicturesShowDifferentTeeth() {
    replay().cursor().jumpTo(2.5);
    waitForPictures();
    const SceneContents one = replay().source()->contentsAt(replay().cursor().moment(), {});
    const SceneContents two = comparison().source()->contentsAt(replay().cursor().otherMoment(), {});
    QVERIFY(one.tooth != nullptr && two.tooth != nullptr && one.tooth != two.tooth);
    QVERIFY(one.tool && two.tool);
    QVERIFY(one.tool->toolInTooth.position != two.tool->toolInTooth.position);
    const double share = differingShare(first().grabFramebuffer(), other()->grabFramebuffer());
    QVERIFY2(share > 0.01, qPrintable(QString::number(share)));
}

/// So the pixels of the test above distinguish teeth, not widgets.
void WindowSideBySideTest::theSameRecordingLooksTheSame() {
    openBeside(recording("expert.ttsession"));
    replay().cursor().jumpTo(2.5);
    waitForPictures();
    const double share = differingShare(first().grabFramebuffer(), other()->grabFramebuffer());
    QVERIFY2(share < 0.001, qPrintable(QString::number(share)));
    openBeside(recording("student.ttsession"));
}

void WindowSideBySideTest::scrubbingMovesBoth() {
    auto& slider = part<ReplaySlider>("replayTime");
    slider.setValue(2800);
    waitForPictures();
    const QImage lateFirst = first().grabFramebuffer(), lateOther = other()->grabFramebuffer();
    QTRY_VERIFY_WITH_TIMEOUT(part<QLabel>("replayViewClock").text().startsWith("0:02.80"), kPatience);
    const QString lateClock = part<QLabel>("replayOtherViewClock").text();
    slider.setValue(700);
    waitForPictures();
    QVERIFY(differingShare(first().grabFramebuffer(), lateFirst) > 0.01);
    QVERIFY(differingShare(other()->grabFramebuffer(), lateOther) > 0.01);
    QTRY_VERIFY_WITH_TIMEOUT(part<QLabel>("replayViewClock").text().startsWith("0:00.70"), kPatience);
    QVERIFY(part<QLabel>("replayOtherViewClock").text() != lateClock);
}

void WindowSideBySideTest::theCameraTurnsBoth() {
    QTRY_VERIFY_WITH_TIMEOUT(looksFromOnePlace(), kPatience);
    waitForPictures();
    for (ToothView* turned : {&first(), other()}) {
        const double before = first().orbitCamera().direction().azimuth;
        const QImage firstBefore = first().grabFramebuffer(), otherBefore = other()->grabFramebuffer();
        drag(*turned);
        QTRY_VERIFY_WITH_TIMEOUT(first().orbitCamera().direction().azimuth != before && looksFromOnePlace(), kPatience);
        waitForPictures();
        QVERIFY(differingShare(first().grabFramebuffer(), firstBefore) > 0.01);
        QVERIFY(differingShare(other()->grabFramebuffer(), otherBefore) > 0.01);
    }
    emit other()->findChild<ViewCube*>()->viewChosen(StandardView::Buccal);
    QTRY_VERIFY_WITH_TIMEOUT(looksFromOnePlace(), kPatience);
    emit first().findChild<ViewCube*>()->viewChosen(StandardView::Occlusal);
    QTRY_VERIFY_WITH_TIMEOUT(looksFromOnePlace(), kPatience);
}

void WindowSideBySideTest::bothBeginAtTheirFirstTouchUntilOneIsShifted() {
    const double one = firstContact(*replay().source()->track());
    const double two = firstContact(*comparison().source()->track());
    QVERIFY(one > 0 && two > 0 && one != two);
    QVERIFY(std::abs(comparison().shift() - (one - two)) < 1e-9);
    auto& shift = part<QDoubleSpinBox>("replayShift");
    QVERIFY(shift.isVisible());
    QVERIFY(std::abs(shift.value() - (one - two)) < 0.006);
    replay().cursor().jumpTo(2);
    const std::uint64_t aligned = replay().cursor().otherMoment();
    shift.setValue(1.5);
    QCOMPARE(comparison().shift(), 1.5);
    QCOMPARE(replay().cursor().otherTime(), 0.5);
    QVERIFY(replay().cursor().otherMoment() < aligned);
    QCOMPARE(replay().cursor().time(), 2.0);
    click("replayAlign");
    QVERIFY(std::abs(comparison().shift() - (one - two)) < 1e-9);
    QCOMPARE(replay().cursor().otherMoment(), aligned);
}

void WindowSideBySideTest::theTimeLineReachesTheEndOfTheLongerOne() {
    const double end = comparison().source()->track()->seconds();  // the student needs longer
    replay().cursor().jumpTo(99);
    QVERIFY(std::abs(replay().cursor().otherTime() - end) < 1e-9);
    QCOMPARE(replay().cursor().moment(), replay().source()->track()->ticks());
    QTRY_VERIFY_WITH_TIMEOUT(part<QLabel>("replayViewClock").text().startsWith("0:03.00 / "), kPatience);
}

void WindowSideBySideTest::thePlotsShowBothInTwoColours() {
    const auto& plots = *window_->findChild<PlotPanel*>();
    replay().cursor().jumpTo(2.5);
    const auto isNear = [&](const TickTrace& trace, double time) {
        return !trace.points().empty() && std::abs(trace.points().back().time - time) < 0.2;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isNear(plots.shown(), 2.5) && plots.shownOther() &&
                                 isNear(plots.shownOther()->trace, replay().cursor().otherTime()),
                             kPatience);
    const QList<QChartView*> charts = plots.findChildren<QChartView*>();
    QCOMPARE(charts.size(), 4);
    for (const QChartView* chart : charts) {
        QList<QColor> colours;
        for (QAbstractSeries* series : chart->chart()->series()) {
            auto* line = qobject_cast<QLineSeries*>(series);
            QVERIFY(line->count() > 10);
            colours << line->pen().color();
        }
        QCOMPARE(colours, (QList<QColor>{kOtherRecordingColour, kFirstRecordingColour}));
    }
    // Long after the end of the first its curve has moved on, too.
    const auto& forces = *charts.last()->chart();
    const auto newest = [&](int series) {
        const auto* line = qobject_cast<QLineSeries*>(forces.series()[series]);
        return line->count() == 0 ? 99 : line->at(line->count() - 1).x();
    };
    QCOMPARE(newest(0), 0.0);
    QCOMPARE(newest(1), 0.0);
    replay().cursor().jumpTo(99);
    const double ago = replay().cursor().time() - replay().source()->track()->seconds();
    QVERIFY(ago > 0.5);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(newest(1) + ago) < 1e-6 && newest(0) == 0, kPatience);
}

void WindowSideBySideTest::theSameButtonBringsTheUsualWindowBack() {
    click("replaySideBySideButton");
    QTRY_VERIFY_WITH_TIMEOUT(isUsualWindow(), kPatience);
    QVERIFY(replay().isActive());
    const auto& plots = *window_->findChild<PlotPanel*>();
    QTRY_VERIFY_WITH_TIMEOUT(!plots.shownOther(), kPatience);
    const QList<QAbstractSeries*> series = plots.findChildren<QChartView*>().last()->chart()->series();
    QCOMPARE(qobject_cast<QLineSeries*>(series.first())->count(), 0);
    openBeside(recording("student.ttsession"));
    click("replayOtherViewClose");
    QTRY_VERIFY_WITH_TIMEOUT(isUsualWindow(), kPatience);
    QVERIFY(replay().source()->file().filename() == "expert.ttsession");
}

void WindowSideBySideTest::theChoiceIsRemembered() {
    QVERIFY(!window_->settings().sideBySide);  // the button has been undone
    WindowSettings settings = window_->settings();
    settings.sideBySide = true;
    window_->apply(settings);
    QVERIFY(window_->settings().sideBySide);
    click("replayCompare");
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QFileDialog*>() != nullptr, kPatience);
    auto* dialog = window_->findChild<QFileDialog*>();
    dialog->selectFile(recording("student.ttsession"));
    QMetaObject::invokeMethod(dialog, "accept");
    waitForOther();
    QVERIFY(comparison().isSideBySide());
    key(Qt::Key_S, Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(isUsualWindow(), kPatience);
    QVERIFY(!window_->settings().sideBySide);
}

void WindowSideBySideTest::aGhostMovesIntoAPictureOfItsOwnAndBack() {
    comparison().open(recording("student.ttsession"), ReplayComparison::Mode::Ghost);
    waitForOther();
    QVERIFY(comparison().isGhost() && other() == nullptr);
    const double shift = comparison().shift();
    key(Qt::Key_S, Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(comparison().isSideBySide() && other() != nullptr && other()->isVisible(), kPatience);
    QVERIFY(window_->settings().sideBySide);
    QCOMPARE(comparison().shift(), shift);
    QVERIFY(!replay().source()->contentsAt(replay().cursor().moment(), {}).other);
    comparison().sideBySideAction().trigger();  // the entry of the menu
    QTRY_VERIFY_WITH_TIMEOUT(comparison().isGhost() && other() == nullptr, kPatience);
    click("replayCompare");
    QTRY_VERIFY_WITH_TIMEOUT(isUsualWindow(), kPatience);
}

void WindowSideBySideTest::closingTheFirstLeavesTheOther() {
    openBeside(recording("student.ttsession"));
    replay().cursor().jumpTo(2);
    const double time = replay().cursor().otherTime();
    drag(first());
    QTRY_VERIFY_WITH_TIMEOUT(looksFromOnePlace(), kPatience);
    const OrbitCamera::Direction direction = first().orbitCamera().direction();
    click("replayViewClose");
    QTRY_VERIFY_WITH_TIMEOUT(isUsualWindow(), kPatience);
    QVERIFY(replay().source()->file().filename() == "student.ttsession");
    QVERIFY(std::abs(replay().cursor().time() - time) < 1e-9);
    QVERIFY(!replay().cursor().isPlaying());
    QCOMPARE(first().orbitCamera().direction().azimuth, direction.azimuth);
    QVERIFY(part<QLabel>("replaySign").text().contains("student.ttsession"));
}

void WindowSideBySideTest::twoRecordingsAreDroppedTogether() {
    WindowSettings settings = window_->settings();
    settings.sideBySide = true;
    window_->apply(settings);
    QMimeData files;
    files.setUrls(
        {QUrl::fromLocalFile(recording("expert.ttsession")), QUrl::fromLocalFile(recording("student.ttsession"))});
    QDragEnterEvent enter(middle(), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);  // without it Qt drops nothing
    QDropEvent drop(QPointF(middle()), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(comparison().isSideBySide(), kLoadPatience);
    QVERIFY(replay().source()->file().filename() == "expert.ttsession");
    QVERIFY(comparison().source()->file().filename() == "student.ttsession");
}

void WindowSideBySideTest::aFileThatIsNoRecordingChangesNothing() {
    waitForOther();
    std::ofstream(folder_ / "text.ttsession") << "no recording";
    click("replayOtherViewClose");
    QTRY_VERIFY_WITH_TIMEOUT(isUsualWindow(), kPatience);
    comparison().open(recording("text.ttsession"), ReplayComparison::Mode::SideBySide);
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    QVERIFY(dismissMessage().contains("text.ttsession"));
    QVERIFY(isUsualWindow());
    QVERIFY(replay().isActive());
}

void WindowSideBySideTest::leavingTheReplayClosesBoth() {
    openBeside(recording("student.ttsession"));
    key(Qt::Key_Escape);
    QVERIFY(!replay().isActive());
    QTRY_VERIFY_WITH_TIMEOUT(view().isVisible() && other() == nullptr, kPatience);
    QVERIFY(!comparison().sideBySideAction().isEnabled());
    QVERIFY(!comparison().sideBySideAction().isChecked());
}

void WindowSideBySideTest::savePictures(const QString& folder, QString first, QString other) {
    initTestCase();
    if (first.isEmpty()) first = recording("expert.ttsession"), other = recording("student.ttsession");
    window_->resize(1400, 900);
    openFirst(first);
    openBeside(other);
    for (const double share : {0.3, 0.95}) {
        replay().cursor().jumpTo(share * replay().cursor().length());
        waitForPictures();
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<PlotPanel*>()->shownOther().has_value(), kPatience);
        waitForSteps(20);
        window_->grab().save(QString("%1/side-by-side-%2.png").arg(folder).arg(share));
    }
    comparison().sideBySideAction().trigger();
    openBeside(other);
    applyColours(true);
    window_->findChild<PlotPanel*>()->setColours();
    waitForPictures();
    waitForSteps(20);
    window_->grab().save(folder + "/side-by-side-dark.png");
    applyColours(false);
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_side_by_side_tests --pictures FOLDER [FIRST OTHER]` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowSideBySideTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2), arguments.value(3), arguments.value(4));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_side_by_side_test.moc"

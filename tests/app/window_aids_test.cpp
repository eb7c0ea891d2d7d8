// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What helps to find one's way in the picture: glass, magnifier, scale bar, letters, view cube.
#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <cmath>
#include <numbers>

#include "app/gui/scene/view_cube.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"

namespace tactooth {

class WindowAidsTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void fromOcclusalTheHandpieceIsGlassUntilAKeyMakesItSolid();
    void theMagnifierIsSwitchedByAKey();
    void theMarksAreSwitchedByKeysAndFollowTheEye();
    void aClickOnTheCubeLooksFromThere();
    void eachAidIsRemembered();
    void theWheelSetsTheDepthAtWhichTheBurStops();
    void theRingLiesUnderThePointer();
    void theRingTakesThePlaceOfTheCursor();
    void whileItsKeyIsHeldTheMouseMovesTheMirror();
    void theMirrorIsPlacedBehindTheBurAndPutBack();
    void overAMarginalRidgeTheRingMarksTheNeighbour();
    void cleanupTestCase();

private:
    [[nodiscard]] std::vector<QWidget*> shownLetters() const;
};

void WindowAidsTest::initTestCase() {
    openWindow();
    waitForTooth();
}

void WindowAidsTest::cleanupTestCase() { closeWindow(); }

std::vector<QWidget*> WindowAidsTest::shownLetters() const {
    std::vector<QWidget*> shown;
    for (auto* letter : view().findChildren<QWidget*>("axisLetterMark")) {
        if (letter->isVisible()) shown.push_back(letter);
    }
    return shown;
}

void WindowAidsTest::fromOcclusalTheHandpieceIsGlassUntilAKeyMakesItSolid() {
    key(Qt::Key_1);
    QTest::mouseMove(&view(), middle());
    waitForSteps(3);
    const QImage glass = view().grabFramebuffer();
    key(Qt::Key_L);
    QVERIFY(!window_->settings().aids.glass);
    const QImage solid = view().grabFramebuffer();
    QVERIFY(solid != glass);
    key(Qt::Key_L);
    QVERIFY(window_->settings().aids.glass);
    key(Qt::Key_0);
}

void WindowAidsTest::theMagnifierIsSwitchedByAKey() {
    auto* frame = view().findChild<QWidget*>("magnifierFrame");
    QVERIFY(!frame->isVisible());
    key(Qt::Key_Z);
    QVERIFY(frame->isVisible());
    QVERIFY(window_->settings().aids.magnifier);
    const QImage with = view().grabFramebuffer();
    key(Qt::Key_Z);
    QVERIFY(!frame->isVisible());
    const QImage without = view().grabFramebuffer();
    const double ratio = view().devicePixelRatioF();
    const QRect corner(frame->geometry().topLeft() * ratio, frame->geometry().size() * ratio);
    QVERIFY(with.copy(corner) != without.copy(corner));
}

void WindowAidsTest::theMarksAreSwitchedByKeysAndFollowTheEye() {
    auto* bar = view().findChild<QWidget*>("scaleBarMark");
    auto* cube = view().findChild<ViewCube*>("viewCube");
    QVERIFY(bar->isVisible() && cube->isVisible());
    key(Qt::Key_2);
    QCOMPARE(shownLetters().size(), std::size_t{4});  // buccal and lingual are along the line of sight
    const QSize before = bar->size();
    for (int i = 0; i < 3; ++i) QTest::keyClick(&view(), Qt::Key_Plus);
    QVERIFY(bar->size() != before);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&view(), Qt::Key_Minus);
    for (const auto which : {Qt::Key_R, Qt::Key_A, Qt::Key_K}) key(which);
    QVERIFY(!bar->isVisible() && !cube->isVisible() && shownLetters().empty());
    key(Qt::Key_0);
    QVERIFY2(shownLetters().empty(), "they stay away when the eye moves");
    for (const auto which : {Qt::Key_R, Qt::Key_A, Qt::Key_K}) key(which);
    QVERIFY(bar->isVisible() && cube->isVisible() && !shownLetters().empty());
}

void WindowAidsTest::aClickOnTheCubeLooksFromThere() {
    auto* cube = view().findChild<ViewCube*>("viewCube");
    QVERIFY(cube->isVisible());
    const auto elevation = [this] { return view().orbitCamera().direction().elevation; };
    const auto clickOn = [&](StandardView face) {
        const std::optional<QPointF> place = cube->middleOf(face);
        QVERIFY(place);
        QTest::mouseClick(cube, Qt::LeftButton, {}, place->toPoint());
    };
    key(Qt::Key_0);  // from buccal and above: both faces can be seen
    clickOn(StandardView::Occlusal);
    QVERIFY(std::abs(elevation() - std::numbers::pi / 2) < 1e-9);
    QVERIFY(!cube->middleOf(StandardView::Buccal));
    key(Qt::Key_0);
    clickOn(StandardView::Buccal);
    QVERIFY(std::abs(elevation()) < 1e-9);
    QVERIFY(!window_->model().manipulator().isPressing());
    key(Qt::Key_0);
}

void WindowAidsTest::theRingTakesThePlaceOfTheCursor() {
    key(Qt::Key_1);
    const auto cursor = [this] { return view().cursor().shape(); };
    const QPoint corner(3, view().height() - 3);
    QTest::mouseMove(&view(), corner);  // a pointer that is there already would not move
    QTest::mouseMove(&view(), middle());
    QTRY_COMPARE_WITH_TIMEOUT(cursor(), Qt::BlankCursor, kPatience);
    QTest::mouseMove(&view(), corner);
    QTRY_COMPARE_WITH_TIMEOUT(cursor(), Qt::CrossCursor, kPatience);
    QTest::mouseMove(&view(), middle());
    QTRY_COMPARE_WITH_TIMEOUT(cursor(), Qt::BlankCursor, kPatience);
    view().setShowsAim(false);
    QCOMPARE(cursor(), Qt::CrossCursor);
    view().setShowsAim(true);
    QTRY_COMPARE_WITH_TIMEOUT(cursor(), Qt::BlankCursor, kPatience);
    QTest::keyPress(&view(), Qt::Key_V);  // the mouse holds the mirror
    QCOMPARE(cursor(), Qt::SizeAllCursor);
    QTest::keyRelease(&view(), Qt::Key_V);
    view().parkMirror();
    key(Qt::Key_0);
}

void WindowAidsTest::whileItsKeyIsHeldTheMouseMovesTheMirror() {
    key(Qt::Key_0);
    QTest::mouseMove(&view(), middle());
    waitForSteps(3);
    const auto mirror = [this] { return window_->model().mirror().pose(); };
    const auto aimedAt = [this] { return *window_->model().manipulator().landing(); };
    const Pose parked = mirror();
    const Vec3 target = aimedAt();
    key(Qt::Key_M);  // hidden: whoever takes it wants to see it
    QVERIFY(!view().showsMirror());
    QTest::keyPress(&view(), Qt::Key_V);
    QVERIFY(view().showsMirror());
    QTest::mouseMove(&view(), middle() + QPoint(40, 25));
    QVERIFY((mirror().position - parked.position).norm() > 0.5);
    const Pose moved = mirror();
    QTest::mousePress(&view(), Qt::LeftButton, {}, middle() + QPoint(40, 25));
    QVERIFY2(!window_->model().manipulator().isPressing(), "the hand is at the mirror");
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, middle() + QPoint(40, 25));
    const QPointF place = middle() + QPoint(40, 25);
    QWheelEvent nearer(place, view().mapToGlobal(place), {}, QPoint(0, 240), Qt::NoButton, {}, Qt::NoScrollPhase,
                       false);
    QApplication::sendEvent(&view(), &nearer);
    QVERIFY(std::abs((mirror().position - moved.position).norm() - 2) < 1e-9);
    QMouseEvent tilt(QEvent::MouseMove, place + QPoint(30, 0), view().mapToGlobal(place), Qt::NoButton, {},
                     Qt::ShiftModifier);
    QApplication::sendEvent(&view(), &tilt);
    QVERIFY(mirror().rotation.angularDistance(parked.rotation) > 0.05);
    QCOMPARE(aimedAt(), target);
    QTest::keyRelease(&view(), Qt::Key_V);
    const Pose left = mirror();
    QTest::mouseMove(&view(), middle());
    QCOMPARE(mirror().position, left.position);
    window_->findChild<QAction*>("parkMirror")->trigger();
    QCOMPARE(mirror().position, parked.position);
}

void WindowAidsTest::theMirrorIsPlacedBehindTheBurAndPutBack() {
    key(Qt::Key_0);
    QTest::mouseMove(&view(), middle());
    waitForSteps(3);
    const Pose parked = window_->model().mirror().pose();
    QTest::keyClick(&view(), Qt::Key_M, Qt::ShiftModifier);
    const Pose placed = window_->model().mirror().pose();
    QVERIFY((placed.position - parked.position).norm() > 0.1);
    const Pose bur = window_->model().log().newest().contact.proxy;
    const Vec3 toEye = (view().camera().cameraInWorld.position - bur.position).normalized();
    QVERIFY((placed.position - bur.position).normalized().dot(toEye) < 0.5);
    QVERIFY((placed.rotation * Vec3::UnitZ()).dot(toEye) > 0);
    QTest::keyClick(&view(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(window_->model().mirror().pose().position, parked.position);
}

void WindowAidsTest::eachAidIsRemembered() {
    WindowSettings settings = window_->settings();
    settings.aids = {
        .glass = false, .scaleBar = false, .letters = true, .cube = false, .magnifier = true, .softTissues = false};
    MainWindow other(*sound_);
    other.apply(settings);
    QVERIFY(other.settings().aids == settings.aids);
    QVERIFY(!other.findChild<QAction*>("glass")->isChecked());
    QVERIFY(other.findChild<QAction*>("magnifier")->isChecked());
    QVERIFY(!other.findChild<QAction*>("softTissues")->isChecked());
    for (const char* name : {"glass", "magnifier", "scaleBar", "axisLetters", "viewCubeSwitch", "softTissues"}) {
        QVERIFY(!other.findChild<QAction*>(name)->toolTip().isEmpty());
    }
}

void WindowAidsTest::theWheelSetsTheDepthAtWhichTheBurStops() {
    auto* depth = window_->findChild<QDoubleSpinBox*>("mouseDepth");
    const double before = depth->value();
    const auto turn = [&](int eighths, Qt::KeyboardModifiers with) {
        QWheelEvent wheel(middle(), view().mapToGlobal(middle()), {}, {0, eighths}, Qt::NoButton, with,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view(), &wheel);
    };
    turn(120, {});
    QVERIFY(std::abs(depth->value() - before - 0.1) < 1e-9);
    turn(-120, Qt::ShiftModifier);
    QVERIFY(std::abs(depth->value() - before - 0.08) < 1e-9);
    QVERIFY(std::abs(window_->model().manipulator().depthControl().depth() - before - 0.08) < 1e-9);
    depth->setValue(before);
}

/// Where it lands, and its numbers.
void WindowAidsTest::theRingLiesUnderThePointer() {
    QTest::mouseMove(&view(), middle() + QPoint(8, 0));
    QTest::mouseMove(&view(), middle());
    QTRY_VERIFY_WITH_TIMEOUT((view().aim().ring().boundingRect().center() - QPointF(middle())).manhattanLength() < 12,
                             kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(view().aim().lines().join(' ').contains("mm"), kPatience);
    QVERIFY(view().aim().warning() == TipWarning::None);
    QVERIFY(window_->model().log().newest().contact.triangles == 0);
    key(Qt::Key_J);
    QVERIFY(view().aim().ring().empty());
    key(Qt::Key_J);
}

/// From above, the palate is right before the eye. It is too near to be drawn, and the mouse does not point at it.
void WindowAidsTest::overAMarginalRidgeTheRingMarksTheNeighbour() {
    window_->teeth().loadMouth({46});
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->mouthTooth, 46, kLoadPatience);
    waitForTooth();
    key(Qt::Key_1);
    const Box3 tooth = window_->model().tooth()->piece->tooth().ownBox();
    const auto aimBeside = [&](double toContact) {  // mm from the mesial contact
        const double x = window_->model().mesialX() > 0 ? tooth.max().x() - toContact : tooth.min().x() + toContact;
        const Vec3 crown(x, tooth.center().y(), tooth.max().z() - 1);
        const auto pixel = project(view().camera(), {view().width(), view().height()}, crown);
        QTest::mouseMove(&view(), QPoint(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())));
        const auto isThere = [&] {
            return std::abs(window_->model().log().newest().contact.proxy.position.x() - x) < 0.5;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isThere(), kPatience);
    };
    aimBeside(0.3);
    QTRY_VERIFY_WITH_TIMEOUT(view().aim().marksBeside(), kPatience);
    QVERIFY(view().aim().lines().contains("Will touch the neighbour or gum"));
    aimBeside(3);
    QTRY_VERIFY_WITH_TIMEOUT(!view().aim().marksBeside() && !view().aim().ring().empty(), kPatience);
    QVERIFY(!view().aim().lines().contains("Will touch the neighbour or gum"));
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowAidsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_aids_test.moc"

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work by the mouth mirror: the mouse points into it, and a dentist's view by it.
#include <QApplication>
#include <algorithm>

#include "app/gui/panels/elided_label.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/scene/aim_overlay.h"
#include "app/gui/scene/session_scene.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "session/control/surface_ray.h"
#include "session/hands/mirror_view.h"

namespace tactooth {

class WindowMirrorTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void theExerciseIsSeenFromTheChairWithTheMirrorBehindTheTooth();
    void inTheMirrorTheMouseAimsAtThePlaceThatItShows();
    void theRingAndTheNumbersAreWhereTheMirrorShowsTheTip();
    void withoutTheMirrorTheMousePointsPastIt();
    void theKeysMoveTiltAndApproachTheMirror();
    void theDentistsViewHoldsTheMirrorToTheChewingSurface();
    void cleanupTestCase();

private:
    /// On the palatal side, as high as the groove of the exercise.
    [[nodiscard]] Vec3 palatalPlace() const;
    [[nodiscard]] QPoint imageOf(const Vec3& place) const;
    [[nodiscard]] QString hint() const { return window_->findChild<ElidedLabel*>("hint")->text(); }
    [[nodiscard]] Pose mirror() const { return window_->model().mirror().pose(); }
};

void WindowMirrorTest::initTestCase() {
    openWindow();
    waitForTooth();
    auto* panel = window_->findChild<ExercisePanel*>();
    const auto& known = panel->known();
    const auto found =
        std::ranges::find_if(known, [](const auto& each) { return each != nullptr && each->id == "mirror-26"; });
    QVERIFY(found != known.end());
    emit panel->chosen(*found);
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().tooth()->mouthTooth, 26, kLoadPatience);
    waitForTooth();
}

void WindowMirrorTest::cleanupTestCase() { closeWindow(); }

Vec3 WindowMirrorTest::palatalPlace() const {
    const auto outer = window_->model().tooth()->piece->tooth().ownOuter();
    const Vec3 start(0, outer->tree().box().min().y() - 20, 3.6);
    const auto hit = firstHit({.base = outer}, {start, Vec3::UnitY()});
    return hit ? Vec3(start + *hit * Vec3::UnitY()) : Vec3(Vec3::Zero());
}

QPoint WindowMirrorTest::imageOf(const Vec3& place) const {
    const Viewport picture = view().viewport();
    const auto pixel = project(picture.camera(), picture.size(), mirrorImage(*mirrorGlass(window_->model()), place));
    return (QPointF(pixel->x(), pixel->y()) / view().devicePixelRatioF()).toPoint();
}

void WindowMirrorTest::theExerciseIsSeenFromTheChairWithTheMirrorBehindTheTooth() {
    const ViewDirection chair = chairView(26).view;
    QVERIFY(std::abs(view().orbitCamera().direction().azimuth - chair.azimuth) < 1e-9);
    QVERIFY(std::abs(view().orbitCamera().direction().elevation - chair.elevation) < 1e-9);
    QVERIFY(view().showsMirror());
}

void WindowMirrorTest::inTheMirrorTheMouseAimsAtThePlaceThatItShows() {
    const Vec3 place = palatalPlace();
    const auto landing = [this] { return window_->model().manipulator().landing(); };
    for (const Vec3& aside : {Vec3(0, 0, 0), Vec3(1.5, 0, 0), Vec3(-1.5, 0, 0.5)}) {
        const QPoint pixel = imageOf(place + aside);
        QTest::mouseMove(&view(), pixel);
        QVERIFY(landing().has_value());
        constexpr double kAPixel = 1.5;  // and rounding to whole ones
        QVERIFY((imageOf(*landing()) - pixel).manhattanLength() <= kAPixel);
        QVERIFY2(landing()->y() < -2, "the side that the eye does not see");
    }
    QTest::mouseMove(&view(), imageOf(place));
    QVERIFY2((*landing() - place).norm() < 0.2, qPrintable(QString::number((*landing() - place).norm())));
}

void WindowMirrorTest::theRingAndTheNumbersAreWhereTheMirrorShowsTheTip() {
    const QPoint pixel = imageOf(palatalPlace());
    QTest::mouseMove(&view(), pixel);
    const auto distance = [&] {
        const QPolygonF ring = view().aim().ringInMirror();
        return ring.size() < 8 ? 1e9 : (ring.boundingRect().center() - QPointF(pixel)).manhattanLength();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(distance() < 14, qPrintable(QString::number(distance())), kPatience);
    QVERIFY(view().aim().glass().containsPoint(pixel, Qt::OddEvenFill));
    QVERIFY(view().aim().lines().join(' ').contains("Depth"));
    QVERIFY(window_->model().log().newest().contact.triangles == 0);
}

void WindowMirrorTest::withoutTheMirrorTheMousePointsPastIt() {
    const QPoint pixel = imageOf(palatalPlace());
    key(Qt::Key_M);
    QTest::mouseMove(&view(), pixel + QPoint(1, 0));
    const auto& landing = window_->model().manipulator().landing();
    QVERIFY(!landing || landing->y() < -4 || landing->z() > 3.8 || (imageOf(*landing) - pixel).manhattanLength() > 3);
    QTRY_VERIFY_WITH_TIMEOUT(view().aim().glass().isEmpty(), kPatience);
    key(Qt::Key_M);
}

void WindowMirrorTest::theKeysMoveTiltAndApproachTheMirror() {
    const Pose parked = mirror();
    QTest::keyPress(&view(), Qt::Key_V);
    for (int i = 0; i < 5; ++i) QTest::keyClick(&view(), Qt::Key_Right);
    const Pose moved = mirror();
    QVERIFY((moved.position - parked.position).norm() > 0.5);
    QVERIFY(moved.rotation.angularDistance(parked.rotation) < 1e-9);
    for (int i = 0; i < 5; ++i) QTest::keyClick(&view(), Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(mirror().rotation.angularDistance(parked.rotation) > 0.02);
    const double distance = view().orbitCamera().distance();
    QTest::keyClick(&view(), Qt::Key_Plus);
    QVERIFY(std::abs((mirror().position - moved.position).norm() - 1) < 1e-9);
    QCOMPARE(view().orbitCamera().distance(), distance);
    QTest::keyRelease(&view(), Qt::Key_V);
    QTest::keyClick(&view(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(mirror().position, parked.position);
}

void WindowMirrorTest::theDentistsViewHoldsTheMirrorToTheChewingSurface() {
    const Pose parked = mirror();
    key(Qt::Key_1);
    key(Qt::Key_0);
    QVERIFY(std::abs(view().orbitCamera().direction().elevation - chairView(26).view.elevation) < 1e-9);
    QVERIFY((mirror().position - parked.position).norm() > 0.5);
    QVERIFY2(hint().contains("12 o'clock"), qPrintable(hint()));
    // The middle half of the crown in both directions, seen from above: most of its chewing surface is in the glass.
    const Box3 crown = window_->model().tooth()->box();
    const auto mouth = touchableSurface(window_->model());
    const MirrorDisc glass = *mirrorGlass(window_->model());
    int places = 0, seen = 0;
    for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
            const Vec3 above(crown.center().x() + i * crown.sizes().x() / 12,
                             crown.center().y() + j * crown.sizes().y() / 12, crown.max().z() + 1);
            const Vec3 place = above - *firstHit(*mouth, {above, -Vec3::UnitZ()}) * Vec3::UnitZ();
            const QPoint pixel = imageOf(place);
            ++places;
            seen += isSeenInMirror(view().viewport(), Vec2(pixel.x(), pixel.y()) * view().devicePixelRatioF(), glass,
                                   place, *mouth)
                        ? 1
                        : 0;
        }
    }
    QVERIFY2(2 * seen > places, qPrintable(QString("%1 of %2").arg(seen).arg(places)));
}

void WindowMirrorTest::savePictures(const QString& folder) {
    initTestCase();
    QTest::mouseMove(&view(), imageOf(palatalPlace()));
    QVERIFY(waitForQuietPicture());
    window_->grab().save(folder + "/mirror-aim.png");
    key(Qt::Key_0);
    QTest::mouseMove(&view(), middle());
    QVERIFY(waitForQuietPicture());
    window_->grab().save(folder + "/mirror-dentist.png");
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_mirror_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowMirrorTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_mirror_test.moc"

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances and angles that are measured in the picture.
#include <QAction>
#include <QApplication>
#include <cmath>

#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "session/control/surface_ray.h"

namespace tactooth {

class WindowMeasureTest : public test::WindowSession {
    Q_OBJECT

public:
    /// Pictures to look at.
    void savePictures(const QString& folder);

private slots:
    void initTestCase();
    void twoClicksMeasureADistanceAndPressNoBur();
    void theMarksStayOnTheToothWhileTheEyeMoves();
    void escapeClearsAndThenEnds();
    void twoClicksMeasureTheAngleBetweenWalls();
    void twoClicksMeasureTheTaperOfWalls();
    void oneClickMeasuresTheRemainingDentin();
    void itIsDoneByKeysAlone();
    void aClickBesideTheToothMarksNothing();
    void anotherToothTakesTheMarksAway();
    void afterwardsTheMousePressesTheBurAgain();
    void cleanupTestCase();

private:
    [[nodiscard]] const MeasureOverlay& overlay() const { return view().measureTool().overlay(); }
    [[nodiscard]] QAction& entry(const char* name) const { return *window_->findChild<QAction*>(name); }
    [[nodiscard]] Vec3 placeUnder(const QPoint& place) const {
        const Ray ray = view().viewport().rayThrough(Vec2(place.x(), place.y()) * view().devicePixelRatioF());
        return ray.origin + firstHit(*touchableSurface(window_->model()), ray).value() * ray.direction;
    }
    /// A place on the chewing surface.
    [[nodiscard]] QPoint crown() const { return middle() + QPoint(0, 80); }
    void click(const QPoint& place) const { QTest::mouseClick(&view(), Qt::LeftButton, {}, place); }
    [[nodiscard]] double number() const {
        return QString(overlay().result()).split(' ')[0].remove(QChar(0xB0)).toDouble();
    }
};

void WindowMeasureTest::initTestCase() {
    openWindow();
    waitForTooth();
    key(Qt::Key_0);
}

void WindowMeasureTest::cleanupTestCase() { closeWindow(); }

void WindowMeasureTest::twoClicksMeasureADistanceAndPressNoBur() {
    QVERIFY(overlay().isHidden());
    key(Qt::Key_I);
    QVERIFY(entry("distance").isChecked() && overlay().isVisible());
    const QPoint first = crown() - QPoint(40, 0), second = crown() + QPoint(50, 20);
    const Pose bur = window_->model().manipulator().pose();
    QTest::mouseMove(&view(), first);
    QTest::mousePress(&view(), Qt::LeftButton, {}, first);
    QVERIFY(!window_->model().manipulator().isPressing());
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, first);
    QCOMPARE(overlay().places().size(), std::size_t{1});
    QVERIFY(overlay().result().isEmpty());
    click(second);
    QCOMPARE(overlay().places().size(), std::size_t{2});
    const double expected = (placeUnder(second) - placeUnder(first)).norm();
    QVERIFY(expected > 1);
    QCOMPARE(overlay().result(), QString("%1 mm").arg(expected, 0, 'f', 2));
    QVERIFY((window_->model().manipulator().pose().position - bur.position).norm() < 1e-9);
    QVERIFY((overlay().places()[0] - QPointF(first)).manhattanLength() < 1.5);
    QVERIFY((overlay().places()[1] - QPointF(second)).manhattanLength() < 1.5);
}

void WindowMeasureTest::theMarksStayOnTheToothWhileTheEyeMoves() {
    const QString before = overlay().result();
    const QPointF place = overlay().places()[0];
    key(Qt::Key_1);
    QCOMPARE(overlay().result(), before);
    QVERIFY((overlay().places()[0] - place).manhattanLength() > 3);
    key(Qt::Key_0);
    QVERIFY((overlay().places()[0] - place).manhattanLength() < 1.5);
}

void WindowMeasureTest::escapeClearsAndThenEnds() {
    key(Qt::Key_Escape);
    QVERIFY(overlay().places().empty() && overlay().result().isEmpty());
    QVERIFY(entry("distance").isChecked());
    key(Qt::Key_Escape);
    QVERIFY(!entry("distance").isChecked() && overlay().isHidden());
    QVERIFY(!entry("clearMeasure").isEnabled());
}

void WindowMeasureTest::twoClicksMeasureTheAngleBetweenWalls() {
    key(Qt::Key_I);
    QTest::keyClick(&view(), Qt::Key_I, Qt::ShiftModifier);  // the one ends the other
    QVERIFY(entry("angle").isChecked() && !entry("distance").isChecked());
    const QPoint first = crown() - QPoint(60, 0), second = crown() + QPoint(60, 10);
    click(first);
    click(second);
    const Surface& tooth = *touchableSurface(window_->model());
    const auto normalAt = [&](const QPoint& place) {
        const Vec2 pixel = Vec2(place.x(), place.y()) * view().devicePixelRatioF();
        return placeOn(tooth, view().viewport().rayThrough(pixel)).value().normal;
    };
    const double cosine = normalAt(first).dot(normalAt(second));
    QVERIFY(overlay().result().endsWith(QChar(0xB0)));
    QVERIFY(std::abs(number() - std::acos(cosine) * 180 / 3.14159265358979) < 0.06);
    QVERIFY(number() > 1);
    click(first);  // begins anew
    QCOMPARE(overlay().places().size(), std::size_t{1});
    click(first);
    QCOMPARE(number(), 0.0);
    QTest::keyClick(&view(), Qt::Key_I, Qt::ShiftModifier);
    QVERIFY(overlay().isHidden());
}

void WindowMeasureTest::twoClicksMeasureTheTaperOfWalls() {
    key(Qt::Key_Y);
    QVERIFY(entry("taper").isChecked());
    click(crown() - QPoint(20, 0));
    click(crown() + QPoint(20, 0));  // two places of the chewing surface
    QVERIFY(overlay().result().isEmpty());
    QCOMPARE(overlay().places().size(), std::size_t{2});
    const QPoint flank = middle() + QPoint(0, 130);
    key(Qt::Key_4);  // mesial, then distal
    click(flank);
    key(Qt::Key_5);
    click(flank);
    QCOMPARE(overlay().places().size(), std::size_t{2});
    QVERIFY2(overlay().result().contains('('), qPrintable(overlay().result()));
    key(Qt::Key_0);
    key(Qt::Key_Y);
    QVERIFY(overlay().isHidden());
}

void WindowMeasureTest::oneClickMeasuresTheRemainingDentin() {
    key(Qt::Key_P);
    QVERIFY(entry("remaining-dentin").isChecked());
    const QPoint place = crown();
    click(place);
    const LayeredTooth& tooth = window_->model().tooth()->piece->tooth();
    const Vec3 point = placeUnder(place);
    const double expected = (nearestPulp(tooth, point).value() - point).norm();
    QVERIFY(expected > 1);
    QCOMPARE(overlay().result(), QString("%1 mm").arg(expected, 0, 'f', 2));
    key(Qt::Key_Escape);
    QVERIFY(overlay().result().isEmpty());
    key(Qt::Key_Escape);
    QVERIFY(overlay().isHidden());
}

void WindowMeasureTest::itIsDoneByKeysAlone() {
    key(Qt::Key_I);
    QCOMPARE(window_->focusWidget(), static_cast<QWidget*>(&view()));
    QTest::mouseMove(&view(), crown());
    QTest::keyClick(&view(), Qt::Key_Return);
    QVERIFY(!window_->model().manipulator().isPressing());
    for (int i = 0; i < 10; ++i) QTest::keyClick(&view(), Qt::Key_Right);
    QTest::keyClick(&view(), Qt::Key_Return);
    QVERIFY(number() > 0.3);
    key(Qt::Key_I);
}

void WindowMeasureTest::aClickBesideTheToothMarksNothing() {
    key(Qt::Key_I);
    click(QPoint(40, view().height() / 2));
    QVERIFY(overlay().places().empty());
    key(Qt::Key_I);
}

void WindowMeasureTest::anotherToothTakesTheMarksAway() {
    key(Qt::Key_I);
    click(crown());
    QCOMPARE(overlay().places().size(), std::size_t{1});
    loadMolar();
    QTRY_VERIFY_WITH_TIMEOUT(overlay().places().empty(), kLoadPatience);
    key(Qt::Key_Escape);
    QVERIFY(overlay().isHidden());
}

void WindowMeasureTest::afterwardsTheMousePressesTheBurAgain() {
    pressBurOn(crown() + QPoint(0, 40));
    QVERIFY(window_->model().manipulator().isPressing());
    QTRY_VERIFY_WITH_TIMEOUT(gauge("forceGauge") > 0.1, kPatience);
    liftBur(crown());
}

void WindowMeasureTest::savePictures(const QString& folder) {
    initTestCase();
    const auto measure = [&](const char* which, const QPoint& first, const QPoint& second, const char* name) {
        entry(which).trigger();
        click(first);
        click(second);
        (void)waitForQuietPicture();
        view().grab().save(folder + '/' + name + ".png");
        entry(which).trigger();
    };
    key(Qt::Key_H);  // nothing in front of the tooth
    measure("distance", crown() - QPoint(60, 10), crown() + QPoint(80, 30), "measure");
    measure("remaining-dentin", crown() - QPoint(60, 10), crown() + QPoint(10, 60), "measure-remaining-dentin");
    key(Qt::Key_4);
    entry("taper").trigger();
    click(middle() + QPoint(0, 130));
    key(Qt::Key_5);
    click(middle() + QPoint(0, 130));
    view().grab().save(folder + "/measure-taper.png");
    entry("taper").trigger();
    key(Qt::Key_0);
    measure("angle", crown() - QPoint(60, 10), crown() + QPoint(10, 90), "measure-angle");
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_measure_tests --pictures FOLDER` saves pictures instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowMeasureTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--pictures") {
        test.savePictures(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_measure_test.moc"

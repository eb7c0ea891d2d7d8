// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A teacher paints the decay of an exercise on its tooth.
#include <algorithm>

#include "app/gui/editor/editor_session.h"

namespace tactooth {

class WindowDecayTest : public test::EditorSession {
    Q_OBJECT

public:
    /// A picture to look at.
    void savePicture(const QString& file);

private slots:
    void initTestCase();
    void decayIsPlacedByAClick();
    void decayIsPaintedByADrag();
    void affectedDentinLiesAroundIt();
    void cleanupTestCase();
};

void WindowDecayTest::initTestCase() {
    openEditorWindow();
    chooseEntry("exerciseMenu", "newExercise");
    waitForEditor();
}

void WindowDecayTest::cleanupTestCase() { closeWindow(); }

void WindowDecayTest::decayIsPlacedByAClick() {
    const CutModel* const before = window_->model().tooth()->piece.get();
    click("drawDecay");
    clickAt(middle() + QPoint(20, 20));
    const auto& lesion = std::get<ToothRequest>(draft().exercise().tooth).lesion;
    QVERIFY(lesion && lesion->place);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().tooth()->piece.get() != before, kLoadPatience);
    waitForTooth();
    const LayeredTooth& tooth = window_->model().tooth()->piece->tooth();
    double nearest = 100;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (!tooth.materials().hasRole(layer.material, MaterialRole::Decay)) continue;
        for (const Vec3f& vertex : layer.part->mesh().vertices)
            nearest = std::min(nearest, (vertex.cast<double>() - *lesion->place).norm());
    }
    QVERIFY2(nearest < 0.3, qPrintable(QString::number(nearest)));
}

void WindowDecayTest::decayIsPaintedByADrag() {
    const CutModel* const before = window_->model().tooth()->piece.get();
    const std::size_t places = draft().decay().size();
    click("drawDecay");
    const QPoint from = middle() + QPoint(-160, 40), to = middle() + QPoint(10, 120);  // begins beside the tooth
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 16; ++i) QTest::mouseMove(&view(), from + (to - from) * i / 16);
    QVERIFY2(window_->model().tooth()->piece.get() == before, "the tooth is made anew at the end of the stroke");
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QVERIFY(draft().decay().size() >= places + 2);
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().tooth()->piece.get() != before, kLoadPatience);
    waitForTooth();
    const std::vector<Vec3> painted = draft().decay();
    QTest::mouseClick(&view(), Qt::RightButton, {}, pixelOf(painted.back()));
    QCOMPARE(draft().decay().size(), painted.size() - 1);
    waitForTooth();
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(draft().decay() == painted);
    waitForTooth();
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(draft().decay().size(), places);
    waitForTooth();
}

void WindowDecayTest::affectedDentinLiesAroundIt() {
    const auto rims = [&] {
        const LayeredTooth& tooth = window_->model().tooth()->piece->tooth();
        return std::ranges::count_if(tooth.layers(), [&](const LayeredTooth::Layer& layer) {
            return tooth.materials().nameOf(layer.material) == "affected-dentin";
        });
    };
    QCOMPARE(rims(), 0);
    setNumber("editRimWidth", 0.6);
    QVERIFY(std::get<ToothRequest>(draft().exercise().tooth).lesion->rim.has_value());
    QTRY_COMPARE_WITH_TIMEOUT(rims(), 1, kLoadPatience);
    waitForTooth();
}

void WindowDecayTest::savePicture(const QString& file) {
    initTestCase();
    click("drawDecay");
    const QPoint from = middle() + QPoint(-60, 60), to = middle() + QPoint(60, 110);
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 16; ++i) QTest::mouseMove(&view(), from + (to - from) * i / 16);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    waitForTooth();
    setNumber("editRimWidth", 0.6);
    waitForTooth();
    (void)waitForQuietPicture();
    window_->grab().save(file);
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_decay_tests --picture FILE` saves a picture instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowDecayTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--picture") {
        test.savePicture(arguments.value(2));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_decay_test.moc"

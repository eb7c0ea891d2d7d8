// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// While a teacher draws an exercise, the tooth shows the ideal cavity that the draft makes now.
#include <QAbstractButton>
#include <QCheckBox>
#include <QPushButton>
#include <QRegularExpression>

#include "app/gui/editor/editor_panel.h"
#include "app/gui/editor/editor_session.h"
#include "app/gui/window/window_owner.h"

namespace tactooth {

class WindowIdealTest : public test::EditorSession {
    Q_OBJECT

public:
    /// A picture to look at. `language`: of the window, "en" or "ja".
    void savePicture(const QString& file, const QString& language);

private slots:
    void initTestCase();
    void itAppearsWhenAnOutlineIsClosed();
    void theBoxSwitchesItOff();
    void aNumberMakesItAnew();
    void aDragTakesItAwayUntilItsEnd();
    void littleDentinAndAnOpenPulpAreWarnedOf();
    void aLineThatMakesNoCavitySaysWhy();
    void itDisappearsWithTheOutline();
    void aTrialShowsItAsATargetAlone();
    void whatTheToothLacksIsSaidInOneSentence();
    void aJapaneseWindowSpeaksJapanese();
    void cleanupTestCase();

private:
    void drawSquare() const;
    void waitForIdeal() const;
    [[nodiscard]] const std::shared_ptr<CavityGhost>& ghost() const { return window_->editor().shownIdeal(); }
    [[nodiscard]] QString state() const { return window_->findChild<QLabel*>("idealState")->text(); }
    [[nodiscard]] double millimetres() const;
    /// The picture at rest, without what lies over it.
    [[nodiscard]] QImage picture() const;
    [[nodiscard]] QRect outlineInPicture(const QImage& image) const;
};

namespace {

/// Pixels that differ clearly within `part`.
int differingPixels(const QImage& a, const QImage& b, const QRect& part) {
    constexpr int kClear = 24;  // of 255
    int count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y) {
        for (int x = part.left(); x <= part.right(); ++x) {
            const QColor one = a.pixelColor(x, y), other = b.pixelColor(x, y);
            const int most = std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                                       std::abs(one.blue() - other.blue())});
            if (most > kClear) ++count;
        }
    }
    return count;
}

}  // namespace

void WindowIdealTest::initTestCase() {
    openEditorWindow();
    chooseEntry("exerciseMenu", "newExercise");
    waitForEditor();
}

void WindowIdealTest::cleanupTestCase() { closeWindow(); }

/// In the middle of the occlusal surface, clicked point by point.
void WindowIdealTest::drawSquare() const {
    view().setView(StandardView::Occlusal);
    const QPoint centre = middle();
    const std::vector<QPoint> corners = {centre + QPoint(-60, -50), centre + QPoint(60, -50), centre + QPoint(60, 50),
                                         centre + QPoint(-60, 50)};
    for (const QPoint& corner : corners) clickAt(corner);
    clickAt(corners.front());
}

void WindowIdealTest::waitForIdeal() const { QTRY_VERIFY_WITH_TIMEOUT(ghost() != nullptr, kLoadPatience); }

/// The first number of the sentence.
double WindowIdealTest::millimetres() const {
    const auto found = QRegularExpression("([0-9]+\\.[0-9]+) mm").match(state());
    return found.hasMatch() ? found.captured(1).toDouble() : -1;
}

QImage WindowIdealTest::picture() const {
    if (!waitForQuietPicture()) return {};
    return view().grabFramebuffer();
}

QRect WindowIdealTest::outlineInPicture(const QImage& image) const {
    const double scale = static_cast<double>(image.width()) / view().width();
    QPolygon polygon;
    for (const Vec3& point : points()) polygon << (QPointF(pixelOf(point)) * scale).toPoint();
    return polygon.boundingRect().intersected(image.rect());
}

void WindowIdealTest::itAppearsWhenAnOutlineIsClosed() {
    QCOMPARE(state(), "There is no ideal cavity yet.");
    QVERIFY(window_->findChild<QCheckBox*>("showIdeal")->isChecked());
    drawSquare();
    QVERIFY(!draft().openLine());
    QVERIFY2(state().startsWith("The ideal cavity is being prepared") && state().endsWith("%"), qPrintable(state()));
    QVERIFY(ghost() == nullptr);
    waitForIdeal();
    QVERIFY(!ghost()->empty());
    QVERIFY2(state().startsWith("Least remaining dentin over the pulp"), qPrintable(state()));
    QVERIFY2(millimetres() > 0.5 && millimetres() < 5, qPrintable(state()));
    QVERIFY(view().findChild<QWidget*>("colourLegend")->isVisible());
}

void WindowIdealTest::theBoxSwitchesItOff() {
    const QImage with = picture();
    const std::shared_ptr<CavityGhost> before = ghost();
    const QRect part = outlineInPicture(with);
    click("showIdeal");
    QVERIFY(ghost() == nullptr);
    const QImage without = picture();
    QCOMPARE(without.size(), with.size());
    const int area = part.width() * part.height();
    QVERIFY2(differingPixels(with, without, part) > area / 2, "the cavity is seen in its outline");
    QVERIFY(!view().findChild<QWidget*>("colourLegend")->isVisible());
    QVERIFY2(millimetres() > 0, "the number stays");
    click("showIdeal");
    QCOMPARE(ghost(), before);
    QCOMPARE(differingPixels(picture(), with, part), 0);
}

void WindowIdealTest::aNumberMakesItAnew() {
    const std::shared_ptr<CavityGhost> before = ghost();
    const double left = millimetres();
    const QImage shallow = picture();
    const double depth = plan().depth;
    setNumber("editDepth", depth + 0.5);
    QVERIFY(ghost() == nullptr);
    QVERIFY2(state().contains("being prepared"), qPrintable(state()));
    waitForIdeal();
    QVERIFY(ghost() != before);
    QVERIFY2(millimetres() < left - 0.3 && millimetres() >= left - 0.52, qPrintable(state()));
    const QImage deep = picture();
    QVERIFY(differingPixels(shallow, deep, outlineInPicture(deep)) > 100);  // deeper glass is darker
    // What does not change the cavity does not take it away.
    const std::shared_ptr<CavityGhost> deeper = ghost();
    setNumber("editMinutes", 7);
    QCOMPARE(ghost(), deeper);
    // Two changes one after the other: the first one is never shown.
    setNumber("editDepth", depth + 0.1);
    setNumber("editDepth", depth);
    waitForIdeal();
    QVERIFY2(std::abs(millimetres() - left) < 0.011, qPrintable(state()));
}

void WindowIdealTest::aDragTakesItAwayUntilItsEnd() {
    const std::shared_ptr<CavityGhost> before = ghost();
    const QPoint from = pixelOf(points()[2]);
    QTest::mouseMove(&view(), from);
    const auto isOnPoint = [&] {
        return view().outlines().marks(OutlineOverlay::Layer::Editor).lines.front().held == std::size_t{2};
    };
    QTRY_VERIFY_WITH_TIMEOUT(isOnPoint(), kPatience);  // the X server has moved the mouse
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    QCOMPARE(ghost(), before);  // nothing has changed yet
    for (int i = 1; i <= 6; ++i) QTest::mouseMove(&view(), from + QPoint(2 * i, 0));
    QVERIFY(ghost() == nullptr);
    waitForSteps(10);
    QCOMPARE(state(), "There is no ideal cavity yet.");
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, from + QPoint(12, 0));
    QVERIFY2(state().contains("being prepared"), qPrintable(state()));
    waitForIdeal();
    QVERIFY(ghost() != before);
    click("editUndo");
    QVERIFY(ghost() == nullptr);
    waitForIdeal();
}

void WindowIdealTest::littleDentinAndAnOpenPulpAreWarnedOf() {
    const double depth = plan().depth, left = millimetres();
    setNumber("editDepth", depth + left - 0.2);
    waitForIdeal();
    QVERIFY2(state().contains("Only 0.") && state().contains("●"), qPrintable(state()));
    QVERIFY2(millimetres() < 0.5, qPrintable(state()));
    QCOMPARE(problem(), "Give the exercise a name.");  // a warning keeps nobody from trying it
    setNumber("editDepth", depth + left + 0.5);
    waitForIdeal();
    QVERIFY2(state().contains("The ideal cavity opens the pulp.") && state().contains("●"), qPrintable(state()));
    setNumber("editDepth", depth);
    waitForIdeal();
    QVERIFY(!state().contains("●"));
}

void WindowIdealTest::aLineThatMakesNoCavitySaysWhy() {
    const QPoint from = pixelOf(points()[1]);
    const QPoint to = (pixelOf(points()[0]) + pixelOf(points()[3])) / 2 - QPoint(40, 0);  // beyond the other side
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i) QTest::mouseMove(&view(), from + (to - from) * i / 8);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    QCOMPARE(problem(), "The outline crosses itself.");
    waitForSteps(10);
    QVERIFY(ghost() == nullptr);
    QCOMPARE(state(), "There is no ideal cavity yet.");
    click("editUndo");
    waitForIdeal();
}

void WindowIdealTest::itDisappearsWithTheOutline() {
    click("freeOutline");
    QVERIFY(points().empty());
    QVERIFY(ghost() == nullptr);
    QVERIFY(problem().startsWith("Draw the outline"));
    waitForSteps(10);
    QVERIFY(ghost() == nullptr);
    QVERIFY(!view().findChild<QWidget*>("colourLegend")->isVisible());
    click("editUndo");
    waitForIdeal();
}

void WindowIdealTest::aTrialShowsItAsATargetAlone() {
    click("templateClassTwoMesial");
    waitForIdeal();
    click("editTry");
    QVERIFY(ghost() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() != nullptr, kLoadPatience);
    waitForTooth();
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QCheckBox*>("ghost")->isChecked(), kLoadPatience);
    QVERIFY(ghost() == nullptr);
    click("editBack");
    QTRY_VERIFY_WITH_TIMEOUT(window_->exercise().active() == nullptr, kLoadPatience);
    waitForTooth();
    waitForIdeal();
    QVERIFY(!window_->findChild<QCheckBox*>("ghost")->isEnabled());
    click("editClose");
    answer(QMessageBox::Discard);
    QVERIFY(ghost() == nullptr);
    QVERIFY(!view().findChild<QWidget*>("colourLegend")->isVisible());
}

/// The removal of decay, on a tooth whose decay the teacher takes away.
void WindowIdealTest::whatTheToothLacksIsSaidInOneSentence() {
    window_->editor().beginCopy(builtinExercise("caries-46"));
    waitForEditor();
    waitForIdeal();
    QCOMPARE(problem(), "The exercise is complete.");
    click("editHasDecay");
    QVERIFY(ghost() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(problem() != "The exercise is complete.", kLoadPatience);
    QCOMPARE(
        problem(),
        "The ideal cavity cannot be made: the tooth has no caries, filling or pulp that is wider than the bur, seen "
        "from the side of the cavity.");
    QVERIFY(!window_->findChild<QPushButton*>("editTry")->isEnabled());
    QCOMPARE(state(), "There is no ideal cavity yet.");
    click("editClose");
    answer(QMessageBox::Discard);
}

void WindowIdealTest::aJapaneseWindowSpeaksJapanese() {
    applyLanguage(*qApp, "ja");
    auto work = window_->releaseSession();
    window_ = std::make_unique<MainWindow>(*sound_);
    window_->restoreSession(std::move(work));
    window_->show();
    waitForTooth();
    chooseEntry("exerciseMenu", "newExercise");
    waitForEditor();
    QCOMPARE(window_->findChild<QCheckBox*>("showIdeal")->text(), QStringLiteral("理想窩洞を表示"));
    QCOMPARE(state(), QStringLiteral("理想窩洞はまだありません。"));
    click("templateClassOne");
    QVERIFY2(state().startsWith(QStringLiteral("理想窩洞を準備しています… ")), qPrintable(state()));
    waitForIdeal();
    QVERIFY2(state().startsWith(QStringLiteral("歯髄までの残存象牙質：最小 ")), qPrintable(state()));
    setNumber("editDepth", plan().depth + millimetres() + 1);
    waitForIdeal();
    QVERIFY2(state().contains(QStringLiteral("しかありません")), qPrintable(state()));
    // The new window has the draft, and makes its ideal.
    work = window_->releaseSession();
    applyLanguage(*qApp, "en");
    window_ = std::make_unique<MainWindow>(*sound_);
    window_->restoreSession(std::move(work));
    window_->show();
    waitForEditor();
    waitForIdeal();
    QVERIFY2(state().contains("Only 0."), qPrintable(state()));
}

void WindowIdealTest::savePicture(const QString& file, const QString& language) {
    applyLanguage(*qApp, language);
    initTestCase();
    click("templateClassTwoMesial");
    waitForIdeal();
    (void)waitForQuietPicture();
    window_->grab().save(file);
    cleanupTestCase();
}

}  // namespace tactooth

/// `window_ideal_tests --picture FILE [LANGUAGE]` saves a picture instead of testing.
int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowIdealTest test;
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == "--picture") {
        test.savePicture(arguments.value(2), arguments.value(3, "en"));
        return 0;
    }
    return QTest::qExec(&test, argc, argv);
}

#include "window_ideal_test.moc"

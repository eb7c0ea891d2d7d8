// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL that goes, is too old or not there; a window that nobody uses; panels behind tabs by keys.
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMainWindow>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPointer>
#include <QProcess>
#include <QSignalSpy>
#include <QTabBar>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <vector>

#include "app/gui/panels/plot_panel.h"
#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"

namespace tactooth {

class WindowGraphicsTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void aLostContextIsMadeAnewWithTheSamePicture();
    void withoutOpenGl41TheProgramSaysWhatToDo_data();
    void withoutOpenGl41TheProgramSaysWhatToDo();
    void whatTheDesktopWantsAgainIsNotDrawnAnew();
    void thePictureComesToRestGradually();
    void whatMovesEndsTheCrossFadeAtOnce();
    void aWindowThatNobodyUsesRests();
    void panelsBehindTabsAreReachedByKeys();
    void cleanupTestCase();

private:
    [[nodiscard]] bool waitForFade();
};

namespace {

/// The mean difference of two pictures of one size, of 255.
double differenceOf(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y), other = b.pixel(x, y);
            sum += std::abs(qRed(one) - qRed(other)) + std::abs(qGreen(one) - qGreen(other)) +
                   std::abs(qBlue(one) - qBlue(other));
        }
    }
    return sum / (3.0 * a.width() * a.height());
}

}  // namespace

void WindowGraphicsTest::initTestCase() {
    openWindow();
    waitForTooth();
}

void WindowGraphicsTest::cleanupTestCase() { closeWindow(); }

/// Another window gives the picture another context: all objects on the graphics card are lost. The new context may lie
/// at the address of the old one.
void WindowGraphicsTest::aLostContextIsMadeAnewWithTheSamePicture() {
    QTRY_VERIFY_WITH_TIMEOUT(view().isAtRest(), kPatience);
    const QImage before = view().grabFramebuffer();
    const std::uint64_t drawn = view().pictures();
    const QPointer<QOpenGLContext> old = view().context();
    auto* picture = &view();
    QSignalSpy failed(picture, &ToothView::failed);
    QMainWindow other;
    other.resize(picture->size());
    other.setCentralWidget(window_->takeCentralWidget());
    other.show();
    QVERIFY(QTest::qWaitForWindowExposed(&other, kPatience));
    QTRY_VERIFY_WITH_TIMEOUT(old.isNull() && picture->context() != nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(picture->pictures() > drawn, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(picture->isAtRest(), kPatience);
    const QImage after = picture->grabFramebuffer();
    window_->setCentralWidget(other.takeCentralWidget());
    QCOMPARE(failed.count(), 0);
    QCOMPARE(after.size(), before.size());
    qint64 differ = 0;
    for (int y = 0; y < after.height(); ++y) {
        for (int x = 0; x < after.width(); ++x) differ += after.pixel(x, y) != before.pixel(x, y) ? 1 : 0;
    }
    QVERIFY2(differ < after.width() * after.height() / 100, qPrintable(QString::number(differ)));
}

void WindowGraphicsTest::withoutOpenGl41TheProgramSaysWhatToDo_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("value");
    QTest::newRow("too old") << "MESA_GL_VERSION_OVERRIDE"
                             << "3.3";
    QTest::newRow("none") << "QT_XCB_GL_INTEGRATION"
                          << "none";
}

void WindowGraphicsTest::withoutOpenGl41TheProgramSaysWhatToDo() {
    QFETCH(QString, name);
    QFETCH(QString, value);
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(name, value);
    environment.insert("XDG_CONFIG_HOME", QString::fromStdString((folder_ / "config").string()));
    environment.insert("XDG_DATA_HOME", QString::fromStdString((folder_ / "data").string()));
    program.setProcessEnvironment(environment);
    program.start(TACTOOTH_PROGRAM, {});
    QVERIFY(program.waitForFinished(kLoadPatience));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 2);
    const QString said = QString::fromUtf8(program.readAllStandardError());
    QVERIFY2(said.contains("the window needs OpenGL 4.1") && said.contains("install the graphics driver"),
             qPrintable(said));
}

void WindowGraphicsTest::whatTheDesktopWantsAgainIsNotDrawnAnew() {
    QVERIFY(waitForQuietPicture());
    const std::uint64_t drawn = view().pictures();
    QSignalSpy composed(&view(), &QOpenGLWidget::frameSwapped);
    for (int i = 0; i < 5; ++i) {
        view().update();  // as after a menu over it
        QVERIFY(composed.wait(kPatience));
    }
    QCOMPARE(view().pictures(), drawn);
    view().setView(StandardView::Distal);
    QTRY_VERIFY_WITH_TIMEOUT(view().pictures() > drawn, kPatience);
}

/// Turns the tooth until the cross-fade to rest has begun. A slow machine may miss the fifth of a second.
bool WindowGraphicsTest::waitForFade() {
    constexpr int kTries = 50;
    for (int i = 0; i < kTries; ++i) {
        const std::uint64_t drawn = view().pictures();
        view().setView(i % 2 == 0 ? StandardView::Mesial : StandardView::Distal);
        const auto hasDrawn = [&] { return view().pictures() > drawn + 1; };  // quickly, then with full quality
        if (!QTest::qWaitFor([&] { return hasDrawn() && (view().isFading() || view().isAtRest()); }, kPatience)) break;
        if (view().isFading()) return true;
    }
    return false;
}

void WindowGraphicsTest::thePictureComesToRestGradually() {
    QVERIFY(waitForQuietPicture());
    QVERIFY(waitForFade());
    const QSignalSpy swapped(&view(), &QOpenGLWidget::frameSwapped);
    std::vector<QImage> seen;
    while (view().isFading()) {
        seen.push_back(view().grabFramebuffer());
        const auto composed = swapped.count();
        QTRY_VERIFY_WITH_TIMEOUT(swapped.count() > composed || !view().isFading(), kPatience);
    }
    QVERIFY(!seen.empty());
    const QImage atRest = view().grabFramebuffer();
    for (std::size_t i = 1; i < seen.size(); ++i) {
        QVERIFY(differenceOf(seen[i], atRest) <= differenceOf(seen[i - 1], atRest));
    }
    QVERIFY(view().isAtRest());
    QCOMPARE(differenceOf(view().grabFramebuffer(), atRest), 0.0);
}

void WindowGraphicsTest::whatMovesEndsTheCrossFadeAtOnce() {
    QVERIFY(waitForQuietPicture());
    QVERIFY(waitForFade());
    const std::uint64_t drawn = view().pictures();
    view().setView(StandardView::Buccal);
    (void)view().grabFramebuffer();  // draws what is due
    QCOMPARE(view().pictures(), drawn + 1);
    QVERIFY(!view().isFading());
    QVERIFY(!view().isAtRest());
}

/// The processor time of all threads. On a quiet machine it is 4 % of a core, half of it the servo's; on one that also
/// builds on its two cores, up to 9. A hypervisor may count in the time that it gives to others: one second below the
/// bound is enough, since a window that keeps drawing exceeds it in each of them. The threads of software OpenGL may
/// still draw the last picture, which the window has long left to them: they come to their end first, and so
/// do the plots, which are drawn on while they show anything that has moved.
void WindowGraphicsTest::aWindowThatNobodyUsesRests() {
    waitForRest();
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<PlotPanel*>()->isFlat(), kPatience);
    view().makeCurrent();
    QOpenGLContext::currentContext()->functions()->glFinish();
    view().doneCurrent();
    const auto used = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    constexpr double kBound = 0.15;  // of a core
    constexpr int kTries = 5;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kTries && least >= kBound; ++i) {
        const double before = used();
        QElapsedTimer elapsed;
        elapsed.start();
        QTest::qWait(1000);
        const double share = 1000 * (used() - before) / static_cast<double>(elapsed.elapsed());
        qInfo("%.1f %% of a core", 100 * share);
        least = std::min(least, share);
    }
    QVERIFY2(least < kBound, qPrintable(QString::number(least)));
}

void WindowGraphicsTest::panelsBehindTabsAreReachedByKeys() {
    QApplication::setActiveWindow(window_.get());
    int switched = 0;
    for (QTabBar* tabs : window_->findChildren<QTabBar*>()) {
        if (!tabs->isVisible() || tabs->count() < 2) continue;
        QWidget* first = QApplication::focusWidget();
        for (int i = 0; i < 100 && !tabs->hasFocus(); ++i) {
            QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : first, Qt::Key_Tab);
        }
        QVERIFY(tabs->hasFocus());
        const int before = tabs->currentIndex();
        QTest::keyClick(tabs, before == 0 ? Qt::Key_Right : Qt::Key_Left);
        QVERIFY(tabs->currentIndex() != before);
        ++switched;
    }
    QCOMPARE(switched, 2);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowGraphicsTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_graphics_test.moc"

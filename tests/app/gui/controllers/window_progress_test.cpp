// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What may take longer than a moment shows how far it is, and cancelling it leaves everything as it was.
#include <QCheckBox>
#include <QPushButton>
#include <filesystem>

#include "app/gui/settings/window_setup.h"
#include "app/window_session.h"
#include "geometry/io/stl_writer.h"
#include "support/shapes.h"

namespace tactooth {

class WindowProgressTest : public test::WindowSession {
    Q_OBJECT

private slots:
    void initTestCase();
    void aToothThatIsMadeShowsItsShare();
    void aToothFromAFileShowsItsShare();
    void anExerciseShowsItsShareAndItsTargetCanBeCancelled();
    void cancellingAnOwnTargetKeepsTheExerciseAndItsTarget();
    void aJumpInTheHistoryCanBeGivenUp();
    void aRestorationCanBeCancelledAndIsOfferedAgain();
    void cleanupTestCase() { closeWindow(); }

private:
    void expectCancelled(const CutModel* piece, const std::function<void()>& begin);
};

void WindowProgressTest::initTestCase() {
    qputenv("XDG_CACHE_HOME", folder_.path().c_str());
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
}

/// `begin` loads another tooth in place of `piece`.
void WindowProgressTest::expectCancelled(const CutModel* piece, const std::function<void()>& begin) {
    begin();
    const std::optional<LongWork> work = window_->teeth().loading();
    QVERIFY(work && work->share && work->cancel);
    QVERIFY(*work->share >= 0 && *work->share <= 1);
    work->cancel();
    QVERIFY(!window_->teeth().loading() && !window_->isBusy());
    waitForSteps(5);
    QVERIFY(window_->model().tooth()->piece.get() == piece);
}

void WindowProgressTest::aToothThatIsMadeShowsItsShare() {
    expectCancelled(window_->model().tooth()->piece.get(),
                    [this] { window_->teeth().loadBuiltinTooth(kBuiltinTeeth[1]); });
    expectCancelled(window_->model().tooth()->piece.get(), [this] { window_->teeth().loadMouth({}); });
}

void WindowProgressTest::aToothFromAFileShowsItsShare() {
    const auto file = folder_ / "ball.stl";
    QVERIFY(writeStl(test::sphere(Vec3::Zero(), 5, 40, 30), file).has_value());
    expectCancelled(window_->model().tooth()->piece.get(),
                    [&] { window_->teeth().openTooth({.outer = file, .layers = {}}); });
}

void WindowProgressTest::anExerciseShowsItsShareAndItsTargetCanBeCancelled() {
    const auto exercise = exercises().front();
    expectCancelled(window_->model().tooth()->piece.get(), [&] { window_->exercise().start(exercise); });
    QVERIFY(window_->exercise().active() == nullptr);

    bool isCancelled = false;  // as soon as the target is being prepared
    const auto cancel = connect(&window_->loop(), &StepLoop::stepped, this, [&] {
        const std::optional<LongWork> work = window_->exercise().preparing();
        if (!work || isCancelled) return;
        isCancelled = work->share && work->cancel;
        work->cancel();
    });
    window_->exercise().start(exercise);
    QTRY_VERIFY_WITH_TIMEOUT(isCancelled, kLoadPatience);
    disconnect(cancel);
    QVERIFY(!window_->exercise().isBusy());
    waitForSteps(5);
    QVERIFY(window_->exercise().active() == exercise);
    QVERIFY(!window_->findChild<QCheckBox*>("ghost")->isEnabled());  // there is no target
}

void WindowProgressTest::cancellingAnOwnTargetKeepsTheExerciseAndItsTarget() {
    const auto exercise = exercises().front();
    window_->exercise().start(exercise);
    auto* ghost = window_->findChild<QCheckBox*>("ghost");
    QTRY_VERIFY_WITH_TIMEOUT(ghost->isChecked(), kLoadPatience);
    const auto before = window_->exercise().targetState().target.metrics;
    const auto file = folder_ / "ball.stl";
    window_->exercise().openTarget(QString::fromStdString(file.string()));
    const std::optional<LongWork> work = window_->exercise().preparing();
    QVERIFY(work && work->share && work->cancel);
    QCOMPARE(window_->exercise().targetFile().toStdString(), file.string());
    work->cancel();
    waitForSteps(5);
    QVERIFY(!window_->exercise().isBusy());
    QVERIFY(window_->exercise().active() == exercise);
    QVERIFY(window_->exercise().targetFile().isEmpty());
    QVERIFY(window_->exercise().targetState().target.metrics == before && ghost->isChecked());
    // One that cannot be read changes nothing, either.
    window_->exercise().openTarget(QString::fromStdString((folder_ / "missing.stl").string()));
    QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, kPatience);
    QVERIFY(dismissMessage().contains("missing.stl"));
    QVERIFY(window_->exercise().active() == exercise);
    QVERIFY(window_->exercise().targetState().target.metrics == before);
}

void WindowProgressTest::aJumpInTheHistoryCanBeGivenUp() {
    loadMolar();
    cutALittle();
    cutALittle();
    const double cut = removed();
    QTRY_COMPARE_WITH_TIMEOUT(window_->model().history().position(), std::size_t{2}, kPatience);
    window_->model().goTo(0);
    QCOMPARE(window_->model().history().share().value_or(-1), 0.0);
    window_->model().giveUpHistory();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->model().history().isBusy(), kPatience);
    QCOMPARE(window_->model().history().position(), std::size_t{2});
    QTRY_COMPARE_WITH_TIMEOUT(removed(), cut, kPatience);
    // After the first of two steps; a test that looks every 50 ms may see none of them.
    bool isGivenUp = false;
    const auto giveUp = connect(&window_->loop(), &StepLoop::stepped, this, [&] {
        if (isGivenUp || window_->model().history().position() == 2) return;
        isGivenUp = true;
        window_->model().giveUpHistory();
    });
    window_->model().goTo(0);
    QTRY_VERIFY_WITH_TIMEOUT(isGivenUp, kPatience);
    disconnect(giveUp);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->model().history().isBusy(), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(removed(), cut, kPatience);
}

void WindowProgressTest::aRestorationCanBeCancelledAndIsOfferedAgain() {
    loadMolar();
    cutALittle();
    const double cut = removed();
    window_->saveBeforeEnd();
    QVERIFY(window_->close());
    closeWindow();
    openWindowWithSettings();
    window_->recordings().setFolder(folder_ / "recordings");
    waitForTooth();
    const CutModel* const piece = window_->model().tooth()->piece.get();
    const auto restore = [this] {
        window_->restorer().offer();
        QMessageBox* question = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((question = window_->findChild<QMessageBox*>("restoreSession")) != nullptr, kPatience);
        QVERIFY(QTest::qWaitForWindowExposed(question, kPatience));
        QTest::mouseClick(question->defaultButton(), Qt::LeftButton);
    };
    expectCancelled(piece, restore);
    QVERIFY(!window_->restorer().isBusy());
    // The work that was given up may hold its file for a moment.
    QTRY_COMPARE_WITH_TIMEOUT(window_->recordings().folder().leftovers().size(), std::size_t{1}, kPatience);
    restore();
    QTRY_VERIFY_WITH_TIMEOUT(window_->model().tooth()->piece.get() != piece, kLoadPatience);
    waitForTooth();
    QTRY_COMPARE_WITH_TIMEOUT(removed(), cut, kPatience);
}

}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    tactooth::WindowProgressTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_progress_test.moc"

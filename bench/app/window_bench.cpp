// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The live window at work: `window_bench [SECONDS [TOOTH.stl | mouth]]` cuts with a bur of 1.2 mm at 50 um, strokes to
// and fro with the mouse, and prints CSV rows: surface updates, new pictures and compositions of the window a second,
// the time from a move of the mouse to the composition of the next picture that is drawn after it (median and 95 % of
// the moves), ticks in a thousand that came late, and the processor time, in percent of one core, that each kind of
// thread took. Three times in turn the bur strokes over the tooth without and with cutting; then it spins above it, and
// then all is at rest. `mouth`: tooth 46 in the whole mouth. On a machine without a display:
//     LIBGL_ALWAYS_SOFTWARE=1 ALSOFT_DRIVERS=null xvfb-run -a -s "-screen 0 1400x900x24" build/release/bin/window_bench
#include <unistd.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "app/gui/panels/drive_panel.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/settings/window_setup.h"
#include "app/gui/window/main_window.h"
#include "sound/output/openal_output.h"

namespace tactooth {
namespace {

/// Processor time of this process so far by the name of the thread, s.
std::map<std::string, double> processorTimes() {
    std::map<std::string, double> times;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        name = name.substr(0, name.find_first_of("-:"));
        std::string line;
        std::getline(std::ifstream(task.path() / "stat"), line);
        // After the name in brackets come the state and ten numbers; the next two are the ticks in user and system.
        std::istringstream rest(line.substr(line.rfind(')') + 1));
        std::string skipped;
        for (int i = 0; i < 11; ++i) rest >> skipped;
        double user = 0, system = 0;
        rest >> user >> system;
        times[name] += (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
    }
    return times;
}

/// What happened while `act` ran for some seconds, as one row.
class Measurement {
public:
    Measurement(MainWindow& window, ToothView& view) : window_(window), view_(view) {
        clock_.start();
        QObject::connect(&view, &QOpenGLWidget::frameSwapped, &view, [this] { compose(); });
    }

    /// The mouse moves now.
    void notify() { moves_.push_back({clock_.elapsed(), view_.pictures()}); }

    template <class Act>
    void run(const char* name, double seconds, Act act) {
        const std::uint64_t updates = window_.model().runner()->feed().surfaceUpdates();
        const auto ticks = [&] { return window_.model().runner()->feed().timing().ticks.load(); };
        const auto missed = [&] { return window_.model().runner()->feed().timing().missed.load(); };
        const auto ticksBefore = static_cast<double>(ticks()), missedBefore = static_cast<double>(missed());
        const auto before = processorTimes();
        compositions_ = 0;
        delays_.clear();
        moves_.clear();
        const std::uint64_t drawn = view_.pictures();
        QElapsedTimer timer;
        timer.start();
        double now = 0;
        for (; now < seconds; now = static_cast<double>(timer.elapsed()) / 1000) act(now);
        const double late = static_cast<double>(missed()) - missedBefore;
        const double all = static_cast<double>(ticks()) - ticksBefore + late;
        std::printf("%s,%.1f,%.1f,%.1f,%.0f,%.0f,%.2f", name,
                    static_cast<double>(window_.model().runner()->feed().surfaceUpdates() - updates) / now,
                    static_cast<double>(view_.pictures() - drawn) / now, compositions_ / now, delay(0.5), delay(0.95),
                    1000 * late / std::max(1.0, all));
        double sum = 0;
        for (const auto& [thread, time] : processorTimes()) {
            const auto known = before.find(thread);
            const double spent = 100 * (time - (known == before.end() ? 0 : known->second)) / now;
            sum += spent;
            if (spent >= 0.1) std::printf(",%s %.1f", thread.c_str(), spent);
        }
        std::printf(",all %.1f\n", sum);
        std::fflush(stdout);
    }

private:
    struct Move {
        qint64 at;             // ms
        std::uint64_t before;  // pictures
    };

    /// Answers the moves after which a picture was drawn.
    void compose() {
        ++compositions_;
        const auto answered = std::partition(moves_.begin(), moves_.end(),
                                             [&](const Move& move) { return move.before == view_.pictures(); });
        for (auto move = answered; move != moves_.end(); ++move) {
            delays_.push_back(static_cast<double>(clock_.elapsed() - move->at));
        }
        moves_.erase(answered, moves_.end());
    }

    /// What this share of the moves waited at most, ms; 0 without moves.
    [[nodiscard]] double delay(double share) {
        if (delays_.empty()) return 0;
        std::sort(delays_.begin(), delays_.end());
        return delays_[static_cast<std::size_t>(share * static_cast<double>(delays_.size() - 1))];
    }

    MainWindow& window_;
    ToothView& view_;
    QElapsedTimer clock_;
    int compositions_ = 0;
    std::vector<Move> moves_;
    std::vector<double> delays_;
};

int run(double seconds, const QString& file) {
    OpenAlOutput sound;
    MainWindow window(sound);
    if (file.isEmpty()) {
        window.teeth().loadBuiltinTooth(kBuiltinTeeth.front());
    } else if (file == "mouth") {
        window.teeth().loadMouth({46});
    } else {
        ToothSource source;
        source.outer = file.toStdString();
        window.teeth().openTooth(source);
    }
    window.teeth().loadBur(*findBur("58"));
    window.show();
    if (!QTest::qWaitForWindowExposed(&window)) return 1;
    if (!QTest::qWaitFor([&] { return !window.isBusy() && window.model().runner() != nullptr; }, 60000)) {
        return 1;
    }
    auto& view = *window.findChild<ToothView*>("toothView");
    window.findChild<QCheckBox*>("keepPedal")->setChecked(true);
    QApplication::setActiveWindow(&window);
    const QPoint start = view.rect().center() + QPoint(-18, 60);
    QTest::mouseMove(&view, start);
    QTest::qWait(1500);
    QTest::mousePress(&view, Qt::LeftButton, {}, start);
    QTest::qWait(500);
    std::printf(
        "# case,updates_per_s,pictures_per_s,compositions_per_s,mouse_to_picture_ms,p95_ms,late_per_thousand,"
        "percent of a core by thread\n");
    Measurement measurement(window, view);
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) {
        for (const bool cuts : {false, true}) {
            QTest::keyClick(&window, cuts ? Qt::Key_C : Qt::Key_T);
            QTest::qWait(1500);  // until the bur has its speed, or stands
            measurement.run(cuts ? "cutting" : "touching", seconds, [&](double now) {
                const double along = now + seconds * round;
                measurement.notify();
                QTest::mouseMove(&view,
                                 start + QPoint(static_cast<int>(20 * std::sin(now)), static_cast<int>(-3 * along)));
                QTest::qWait(16);
            });
        }
    }
    const double removed = total(window.model().runner()->feed().removed());
    std::printf("# removed %.2f mm3\n", removed);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, start);
    QTest::mouseMove(&view, start + QPoint(0, -100));  // clear of the tooth
    QTest::qWait(500);
    measurement.run("spinning", seconds, [](double) { QTest::qWait(50); });
    window.findChild<QCheckBox*>("keepPedal")->setChecked(false);
    QTest::qWait(12000);  // until the bur stands and the plots are empty
    measurement.run("rest", seconds, [](double) { QTest::qWait(200); });
    return removed > 0 ? 0 : 1;
}

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    const auto application = tactooth::startApplication(argc, argv);
    const QStringList arguments = QApplication::arguments();
    return tactooth::run(std::max(1.0, arguments.value(1, "6").toDouble()), arguments.value(2));
}

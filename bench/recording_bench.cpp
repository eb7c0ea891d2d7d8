// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// What a recording costs the servo thread: a tick of the servo stage without and with its event in the queue, in turn,
// while another thread empties the queue. Prints a table.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "session/kernel/event_lanes.h"
#include "session/kernel/event_merger.h"
#include "session/kernel/servo_stage.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {
namespace {

constexpr int kTicks = 200'000;  // of each kind

std::shared_ptr<const Surface> block() {
    auto tooth = LayeredTooth::make(test::box(Vec3(-3, -3, -2), Vec3(3, 3, 0)), {}, test::kDentin);
    auto surface = std::make_shared<Surface>();
    surface->base = tooth->outer();
    return surface;
}

Instrument bur() {
    const TriangleMesh mesh = test::cylinder(Vec3::Zero(), 0.5, 4, 32);
    return {std::make_shared<const ToolShape>(mesh), {*RevolutionEnvelope::make(mesh), 1}};
}

OperatorInput circling(int tick) {
    const double angle = 0.002 * tick;
    const Vec3 tip(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0.1 - 0.3 * std::sin(0.01 * tick));
    return {{tip, Quat::Identity()}, 1, false};
}

void printRow(const char* title, std::vector<double> micros) {
    std::ranges::sort(micros);
    const auto at = [&](double share) { return micros[static_cast<std::size_t>(share * (micros.size() - 1.0))]; };
    fmt::print("{:<44} {:>8.3f} {:>8.3f} {:>8.3f} {:>9.3f}\n", title, at(0.5), at(0.99), at(0.999), at(1));
}

/// Takes what comes, as the recorder does.
std::jthread emptying(EventLanes& lanes) {
    return std::jthread([&lanes](const std::stop_token& stop) {
        EventMerger merger;
        std::vector<SessionEvent> events;
        while (!stop.stop_requested()) {
            lanes.drain(merger);
            merger.take(events);
            events.clear();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    });
}

void run() {
    ServoStage servo(bur(), block(), HapticSettings());
    EventLanes lanes;
    const std::jthread recorder = emptying(lanes);
    std::vector<double> without, with, event;
    for (auto* times : {&without, &with, &event}) times->reserve(kTicks);
    using Clock = std::chrono::steady_clock;
    const auto micros = [](Clock::duration time) { return std::chrono::duration<double, std::micro>(time).count(); };
    for (int i = 0; i < 2 * kTicks; ++i) {
        if (i % 1000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the queue is emptied
        const auto start = Clock::now();
        const TickInput input = TickInput::of(circling(i), 0.001);
        (void)servo.step(input);
        const auto stepped = Clock::now();
        if (i % 2 == 1) lanes.servo(TickEvent{input, 0});
        const auto end = Clock::now();
        (i % 2 == 1 ? with : without).push_back(micros(end - start));
        if (i % 2 == 1) event.push_back(micros(end - stepped));
    }
    fmt::print("{:<44} {:>8} {:>8} {:>8} {:>9}\n", "us", "p50", "p99", "p99.9", "max");
    printRow("A: tick", std::move(without));
    printRow("B: tick and its event", std::move(with));
    printRow("of B: the event alone, with one clock reading", std::move(event));
    if (lanes.hasOverflowed()) fmt::print("The queue was full: run it on a quieter machine.\n");
}

}  // namespace
}  // namespace tactooth

int main() { tactooth::run(); }

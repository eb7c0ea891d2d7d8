// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A recorded tick must not wait either: ticks run in a process that the kernel kills at its first system call, and each
// use of the heap is counted. (A lock that is free needs no system call; the queues have none: see event_lanes.h.)
#include <gtest/gtest.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>

#include "session/kernel/event_lanes.h"
#include "session/kernel/servo_stage.h"
#include "support/heap_counter.h"
#include "support/materials.h"
#include "support/shapes.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {
namespace {

constexpr int kNoSeccomp = 3;   // exit status
constexpr int kFailed = 4;      // exit status
constexpr int kTicks = 20'000;  // more than the queue holds: a full one must not wait either

OperatorInput circling(int tick) {
    const double angle = 0.002 * tick;
    return {{Vec3(1.5 * std::cos(angle), 1.5 * std::sin(angle), 0.1 - 0.3 * std::sin(0.01 * tick)), Quat::Identity()},
            1,
            false};
}

int runSealed(ServoStage& servo, EventLanes& lanes) {
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) return kNoSeccomp;
    const long before = test::heapCalls();
    int touching = 0;
    for (int i = 1; i <= kTicks; ++i) {
        const TickInput input = TickInput::of(circling(i), 0.001);
        touching += servo.step(input).contact.triangles > 0 ? 1 : 0;
        lanes.servo(TickEvent{input, 0});
        if (i % 1000 == 0) lanes.servo(TickHashEvent{servo.hash()});
    }
    return test::heapCalls() == before && touching > kTicks / 4 && lanes.hasOverflowed() ? 0 : kFailed;
}

TEST(RecordedTick, CallsNoKernelAndUsesNoHeap) {
    const TriangleMesh mesh = test::cylinder(Vec3::Zero(), 0.5, 4, 32);
    const Instrument bur = {std::make_shared<const ToolShape>(mesh), {*RevolutionEnvelope::make(mesh), 1}};
    auto tooth = LayeredTooth::make(test::box(Vec3(-3, -3, -2), Vec3(3, 3, 0)), {}, test::kDentin);
    auto surface = std::make_shared<Surface>();
    surface->base = tooth->outer();
    ServoStage servo(bur, surface, HapticSettings());
    (void)servo.step(TickInput::of(circling(0), 0.001));  // finds the first pose, which may allocate
    EventLanes lanes;
    const pid_t child = fork();
    if (child == 0) syscall(SYS_exit, runSealed(servo, lanes));  // of this thread only: more is not allowed
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNoSeccomp) GTEST_SKIP() << "this kernel seals no process";
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status) << ": a tick called the kernel";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The servo thread must not wait: 100,000 ticks run in a process that the kernel kills at its first system call, and
// every lock is counted. Two such processes return a hash of all forces and poses: it is the same, bit for bit.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <csignal>
#include <mutex>

#include "collision/contact_oracle.h"
#include "geometry/util/fnv1a.h"
#include "haptics/haptic_simulation.h"
#include "haptics/safety_limiter.h"
#include "support/servo_tick.h"

namespace {

std::atomic<long> locks{0};

template <class Function>
Function realOne(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static const auto real = realOne<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
    ++locks;
    return real(mutex);
}
extern "C" int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
    static const auto real = realOne<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
    ++locks;
    return real(lock);
}
extern "C" int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
    static const auto real = realOne<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
    ++locks;
    return real(lock);
}

namespace tactooth {
namespace {

using test::kTick;
constexpr int kNoSeccomp = 3;   // exit status
constexpr double kReach = 1.5;  // mm that the hand goes aside

struct Report {
    std::uint64_t hash;
    long locks;
    int touching;
};

/// A device that circles over the top of a tooth and presses into it, and lifts off now and then.
OperatorInput handAt(const Vec3& top, int tick) {
    const double time = kTick * tick;
    const Vec3 aside(std::cos(2.1 * time), std::sin(3.3 * time), 0.5 * std::sin(1.7 * time) - 0.7);
    return {{top + kReach * aside, Quat(Eigen::AngleAxisd(0.3 * std::sin(time), Vec3::UnitX()))}, 0, false};
}

/// The middle of the tooth, as high as the tooth is where the hand circles: the fossa of a molar lies below its cusps.
Vec3 topOf(const TriangleMesh& tooth) {
    const Box3 box = boundingBox(tooth);
    Vec3 top(box.center().x(), box.center().y(), box.min().z());
    for (const Vec3f& vertex : tooth.vertices) {
        const Vec3 place = vertex.cast<double>();
        if ((place - top).head<2>().norm() < kReach) top.z() = std::max(top.z(), place.z());
    }
    return top;
}

/// The ticks only, from the moment when the process may only compute.
Report sealedTicks(HapticSimulation& simulation, const Vec3& top, int ticks) {
    SafetyLimiter limiter{ForceLimits{}};
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) syscall(SYS_exit, kNoSeccomp);
    Report report{0, locks, 0};
    Fnv1a hash;
    for (int i = 1; i <= ticks; ++i) {
        const Tick tick = simulation.step(handAt(top, i), kTick);
        const auto wrench = limiter.limit(tick.force.wrench, kTick, tick.contact.placed, 0);
        report.touching += tick.contact.triangles > 0 ? 1 : 0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double value : {wrench.force()[axis], wrench.torque()[axis], tick.contact.proxy.position[axis]})
                hash.addWord(std::bit_cast<std::uint64_t>(value));
        }
    }
    report.hash = hash.value();
    report.locks = locks - report.locks;
    return report;
}

/// Runs the ticks in a separate process. Its exit status is in `status`.
Report ticksInASealedProcess(ContactMode mode, int ticks, int& status) {
    const TriangleMesh& tooth = test::oracleTeeth()[2].mesh;
    HapticSettings settings;
    settings.mode = mode;
    const auto tool = test::toolOf(test::oracleTools()[0].mesh);
    HapticSimulation simulation(tool, tool->radius(), test::surfaceOf(tooth), settings);
    const Vec3 top = topOf(tooth);
    (void)simulation.step(handAt(top, 0), kTick);  // finds the first pose, which may allocate
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        const Report report = sealedTicks(simulation, top, ticks);
        const bool sent = write(ends[1], &report, sizeof report) == sizeof report;
        syscall(SYS_exit, sent ? 0 : 1);  // of this thread only: more is not allowed
    }
    close(ends[1]);
    Report report{};
    if (read(ends[0], &report, sizeof report) != sizeof report) report = {};
    close(ends[0]);
    waitpid(child, &status, 0);
    return report;
}

class RealTimeSafe : public ::testing::TestWithParam<ContactMode> {};

std::string modeName(const ::testing::TestParamInfo<ContactMode>& mode) {
    return mode.param == ContactMode::Proxy ? "Proxy" : "Penalty";
}

}  // namespace

TEST(RealTimeSafeSelf, SeesALock) {
    std::mutex mutex;
    const long before = locks;
    mutex.lock();
    mutex.unlock();
    EXPECT_EQ(locks, before + 1);
}

TEST(RealTimeSafeSelf, ASealedProcessDiesOfASystemCall) {
    const pid_t child = fork();
    if (child == 0) {
        if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) syscall(SYS_exit, kNoSeccomp);
        syscall(SYS_getpid);
        syscall(SYS_exit, 0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNoSeccomp) GTEST_SKIP() << "this kernel seals no process";
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

TEST_P(RealTimeSafe, TicksCallNoKernelTakeNoLockAndRepeatBitForBit) {
    const int ticks = GetParam() == ContactMode::Proxy ? 100000 : 10000;  // penalty mode is slow
    int status = 0;
    const Report first = ticksInASealedProcess(GetParam(), ticks, status);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNoSeccomp) GTEST_SKIP() << "this kernel seals no process";
    ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status) << ": a tick called the kernel";
    ASSERT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(first.locks, 0);
    EXPECT_GT(first.touching, ticks / 4);
    EXPECT_LT(first.touching, ticks);
    const Report second = ticksInASealedProcess(GetParam(), ticks, status);
    EXPECT_EQ(second.hash, first.hash);
    EXPECT_EQ(second.touching, first.touching);
}

INSTANTIATE_TEST_SUITE_P(InBothModes, RealTimeSafe, ::testing::Values(ContactMode::Proxy, ContactMode::Penalty),
                         modeName);

}  // namespace tactooth

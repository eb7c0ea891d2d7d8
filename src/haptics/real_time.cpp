// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/real_time.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>

#include "haptics/cpu_latency_request.h"

namespace tactooth {
namespace {

constexpr int kPriority = 60;  // above ordinary threads, below the interrupt threads of the kernel

std::atomic<bool> locked{false};

rlimit limitOf(decltype(RLIMIT_RTPRIO) what) {
    rlimit limit{};
    getrlimit(what, &limit);
    return limit;
}

bool mayLockMemory() { return geteuid() == 0 || limitOf(RLIMIT_MEMLOCK).rlim_cur == RLIM_INFINITY; }

}  // namespace

bool acquireRealTimePriority() {
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

/// Pages are locked at their first use: a large tooth of which only parts are used stays cheap.
bool lockMemory() {
    locked = mayLockMemory() && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
    return locked;
}

bool isMemoryLocked() { return locked; }

RealTimeRights realTimeRights() {
    RealTimeRights rights;
    rights.priority = geteuid() == 0 || limitOf(RLIMIT_RTPRIO).rlim_cur >= static_cast<rlim_t>(kPriority);
    rights.memory = mayLockMemory();
    rights.cpuLatency = mayLimitCpuLatency();
    return rights;
}

std::string missingRights(const RealTimeRights& rights) {
    std::string missing;
    const auto add = [&missing](bool allowed, const char* what) {
        if (!allowed) missing += std::string(missing.empty() ? "" : ", ") + what;
    };
    add(rights.priority, "real-time priority");
    add(rights.memory, "locked memory");
    add(rights.cpuLatency, "keeping the processors from deep sleep");
    return missing;
}

std::string realTimeHint(const RealTimeRights& rights) {
    std::string hint;
    if (!rights.priority || !rights.memory) {
        hint =
            "For a steadier force write '@audio - rtprio 95' and '@audio - memlock unlimited' to "
            "/etc/security/limits.d/tactooth.conf, add yourself to the group 'audio' and log in again.";
    }
    if (!rights.cpuLatency) {
        hint += std::string(hint.empty() ? "" : " ") +
                "To keep the processors from deep sleep between two ticks write "
                "'KERNEL==\"cpu_dma_latency\", GROUP=\"audio\", MODE=\"0660\"' to "
                "/etc/udev/rules.d/99-tactooth.rules, be in the group 'audio' and restart the computer.";
    }
    return hint;
}

}  // namespace tactooth

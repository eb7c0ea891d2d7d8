// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/real_time.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace tactooth {
namespace {

constexpr int kPriority = 60;  // above everything ordinary, below the kernel's own interrupt threads

rlimit limitOf(decltype(RLIMIT_RTPRIO) what) {
    rlimit limit{};
    getrlimit(what, &limit);
    return limit;
}

bool mayLockMemory() { return geteuid() == 0 || limitOf(RLIMIT_MEMLOCK).rlim_cur == RLIM_INFINITY; }

}  // namespace

bool takeRealTimePriority() {
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

/// Pages are locked as they are first used: a large tooth that is only looked at part by part stays cheap.
bool lockMemory() { return mayLockMemory() && mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0; }

RealTimeRights realTimeRights() {
    RealTimeRights rights;
    rights.priority = geteuid() == 0 || limitOf(RLIMIT_RTPRIO).rlim_cur >= static_cast<rlim_t>(kPriority);
    rights.memory = mayLockMemory();
    return rights;
}

std::string realTimeHint(const RealTimeRights& rights) {
    if (rights.priority && rights.memory) return {};
    return "For a steadier force write '@audio - rtprio 95' and '@audio - memlock unlimited' to "
           "/etc/security/limits.d/tactooth.conf, add yourself to the group 'audio' and log in again.";
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/cpu_latency_request.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <string>

// Linux kernel documentation, "PM Quality Of Service Interface": the request is an open file. It ends when the file is
// closed.

namespace tactooth {
namespace {

constexpr const char* kRequests = "/dev/cpu_dma_latency";
constexpr std::int32_t kMaxCpuLatency =
    10;  // us: allows the light idle states of present processors, not those of 100 us and more

/// The host takes away an idle processor of a virtual machine, and gives it back when it has time. So it must not sleep
/// at all.
bool isVirtualMachine() {
    std::ifstream file("/sys/devices/system/cpu/cpuidle/current_driver");
    std::string driver;
    file >> driver;
    return driver == "haltpoll";
}

}  // namespace

CpuLatencyRequest::CpuLatencyRequest() {
    const int request = ::open(kRequests, O_WRONLY | O_CLOEXEC);
    if (request < 0) return;
    const std::int32_t longest = isVirtualMachine() ? 0 : kMaxCpuLatency;
    if (::write(request, &longest, sizeof longest) == sizeof longest) {
        request_ = request;
    } else {
        ::close(request);
    }
}

CpuLatencyRequest::~CpuLatencyRequest() {
    if (request_ >= 0) ::close(request_);
}

bool mayLimitCpuLatency() { return ::access(kRequests, W_OK) == 0 || errno == ENOENT; }

}  // namespace tactooth

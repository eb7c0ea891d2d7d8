// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// While an object lives, no processor sleeps so deeply that its wake-up delays a tick. A servo loop idles for nine
/// tenths of each millisecond. A processor in a deep idle state needs 0.1 ms to wake up, or several milliseconds in a
/// virtual machine. Has no effect where the system forbids it.
class CpuLatencyRequest {
public:
    CpuLatencyRequest();
    ~CpuLatencyRequest();
    CpuLatencyRequest(const CpuLatencyRequest&) = delete;
    CpuLatencyRequest& operator=(const CpuLatencyRequest&) = delete;

    [[nodiscard]] bool isGranted() const { return request_ >= 0; }

private:
    int request_ = -1;
};

/// Whether this user may make such a request; nothing is requested. True where the system has no such feature: then the
/// user need not do anything.
[[nodiscard]] bool mayLimitCpuLatency();

}  // namespace tactooth

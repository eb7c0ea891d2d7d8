// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// As long as one lives, no processor sleeps so deeply that waking it delays a tick: a servo loop idles nine tenths of
/// each millisecond, and a processor that falls into deep sleep then needs 0.1 ms to come back, or several when its
/// sleep is that of a virtual machine. Changes nothing where the system forbids it.
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

/// Whether this user may have it, without taking it. True where the system has no such thing: nothing is to be done.
[[nodiscard]] bool mayLimitCpuLatency();

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

namespace tactooth {

/// A counter in shared memory on which a thread sleeps until a thread of another process counts on (a futex). A ring is
/// never missed: who waits says how many rings it has seen.
class Bell {
public:
    [[nodiscard]] std::uint32_t rings() const { return rings_.load(std::memory_order_acquire); }
    /// Any thread, any signal handler. Does not block.
    void ring();
    /// Returns when there are more rings than `seen`, or at the time `until`, s of the monotonic clock. May return
    /// early.
    void wait(std::uint32_t seen, double until) const;

private:
    std::atomic<std::uint32_t> rings_{0};
};
static_assert(sizeof(Bell) == 4 && std::atomic<std::uint32_t>::is_always_lock_free, "the kernel reads this number");

}  // namespace tactooth

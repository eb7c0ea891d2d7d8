// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>

namespace tactooth {

/// A mailbox for the newest value only, from one writing thread to one reading thread. Both sides are wait-free: three
/// slots, of which the writer owns one, the reader one, and the third is exchanged.
template <class T>
class TripleBuffer {
public:
    explicit TripleBuffer(const T& first = T()) { slots_.fill(first); }

    /// Writer: replaces whatever has not been read yet.
    void write(const T& value) {
        slots_[written_] = value;
        written_ = middle_.exchange(written_ | kFresh, std::memory_order_acq_rel) & kSlot;
    }

    /// Reader: fetches the newest value if one was written since the last call; true if so.
    bool refresh() {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
        read_ = middle_.exchange(read_, std::memory_order_acq_rel) & kSlot;
        return true;
    }

    /// Reader: what the last refresh() fetched, the first value before that.
    [[nodiscard]] const T& value() const { return slots_[read_]; }

private:
    static constexpr unsigned kSlot = 3;
    static constexpr unsigned kFresh = 4;

    std::array<T, 3> slots_;
    std::atomic<unsigned> middle_{1};
    alignas(64) unsigned written_ = 0;  // writer's alone
    alignas(64) unsigned read_ = 2;     // reader's alone
};

}  // namespace tactooth

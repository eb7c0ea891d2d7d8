// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>

#include "geometry/util/assert.h"

namespace tactooth {

/// A mailbox for the newest value only, from one writing thread to one reading thread. Both sides are wait-free. It has
/// three slots: the writer owns one, the reader owns one, and the third is exchanged.
template <class T>
class TripleBuffer {
public:
    explicit TripleBuffer(const T& first = T()) { slots_.fill(first); }

    /// Writer: replaces a value that has not been read yet.
    void write(const T& value) {
        slots_[written_] = value;
        written_ = middle_.exchange(written_ | kFresh, std::memory_order_acq_rel) & kSlot;
        TACTOOTH_ASSERT(written_ < slots_.size());
    }

    /// Reader: fetches the newest value. Returns true if one was written since the last call.
    bool refresh() {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
        read_ = middle_.exchange(read_, std::memory_order_acq_rel) & kSlot;
        TACTOOTH_ASSERT(read_ < slots_.size());
        return true;
    }

    /// Reader: the value of the last refresh(), or the first value before that.
    [[nodiscard]] const T& value() const { return slots_[read_]; }

private:
    static constexpr unsigned kSlot = 3;
    static constexpr unsigned kFresh = 4;

    std::array<T, 3> slots_;
    std::atomic<unsigned> middle_{1};
    alignas(64) unsigned written_ = 0;  // for the writer only
    alignas(64) unsigned read_ = 2;     // for the reader only
};

}  // namespace tactooth

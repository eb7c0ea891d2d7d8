// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tactooth {

/// The memory of a mailbox for the newest value, from one process to another; see SlotWriter and SlotReader. It is a
/// triple buffer whose words are atomic: a writer that ends, or stops, in the middle of a value holds nobody up, and
/// its value is never seen. Which slot a side owns is known to that side alone, so the other one cannot change it.
template <class T>
class SharedSlots {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0);
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

private:
    template <class U>
    friend class SlotWriter;
    template <class U>
    friend class SlotReader;

    static constexpr std::size_t kWords = sizeof(T) / sizeof(std::uint64_t);
    static constexpr std::uint32_t kSlots = 3;
    static constexpr std::uint32_t kSlot = 3;  // mask
    static constexpr std::uint32_t kFresh = 4;

    using Words = std::array<std::uint64_t, kWords>;

    alignas(64) std::array<std::array<std::atomic<std::uint64_t>, kWords>, kSlots> slots_{};
    alignas(64) std::atomic<std::uint32_t> middle_{1};
};

/// The writing side of a mailbox that no other has written to before. One thread; wait-free.
template <class T>
class SlotWriter {
public:
    explicit SlotWriter(SharedSlots<T>& memory) : slots_(&memory) {}

    /// Replaces a value that has not been read yet.
    void write(const T& value) {
        const auto words = std::bit_cast<typename SharedSlots<T>::Words>(value);
        auto& slot = slots_->slots_[own_];
        for (std::size_t i = 0; i < words.size(); ++i) slot[i].store(words[i], std::memory_order_relaxed);
        const std::uint32_t before =
            slots_->middle_.exchange(own_ | SharedSlots<T>::kFresh, std::memory_order_acq_rel) & SharedSlots<T>::kSlot;
        if (before < SharedSlots<T>::kSlots) own_ = before;  // else the other process has written nonsense
    }

private:
    SharedSlots<T>* slots_;
    std::uint32_t own_ = 0;
};

/// The reading side of a mailbox that no other has read from before. One thread; wait-free.
template <class T>
class SlotReader {
public:
    explicit SlotReader(SharedSlots<T>& memory) : slots_(&memory) {}

    /// Fetches the newest value. True if one was written since the last call.
    bool refresh() {
        if ((slots_->middle_.load(std::memory_order_relaxed) & SharedSlots<T>::kFresh) == 0) return false;
        const std::uint32_t newest = slots_->middle_.exchange(own_, std::memory_order_acq_rel) & SharedSlots<T>::kSlot;
        if (newest >= SharedSlots<T>::kSlots) return false;  // nonsense of the other process
        own_ = newest;
        typename SharedSlots<T>::Words words;
        const auto& slot = slots_->slots_[own_];
        for (std::size_t i = 0; i < words.size(); ++i) words[i] = slot[i].load(std::memory_order_relaxed);
        value_ = std::bit_cast<T>(words);
        return true;
    }

    /// The value of the last successful refresh(), or the default value before.
    [[nodiscard]] const T& value() const { return value_; }

private:
    SharedSlots<T>* slots_;
    T value_{};
    std::uint32_t own_ = 2;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

/// Memory aligned to 64 bytes, or nullptr if there is none. From 4 MB on it uses pages of 2 MB where the system has
/// them. The first access to fresh memory, which on small pages costs more than filling it, is then about ten times
/// cheaper.
[[nodiscard]] void* allocateOnLargePages(std::size_t bytes) noexcept;
void freeLargePages(void* memory) noexcept;

/// Allocator of a std::vector on such memory. `resize` does not initialise the new elements: several threads may then
/// access them first.
template <class T>
class LargePageAllocator {
public:
    using value_type = T;

    LargePageAllocator() = default;
    template <class U>
    LargePageAllocator(const LargePageAllocator<U>&) {}  // NOLINT: required of an allocator, and may convert

    [[nodiscard]] T* allocate(std::size_t count) {
        TACTOOTH_ASSERT(count <= std::numeric_limits<std::size_t>::max() / sizeof(T));
        if (void* memory = allocateOnLargePages(count * sizeof(T))) return static_cast<T*>(memory);
        throw std::bad_alloc();
    }
    void deallocate(T* memory, std::size_t /*count*/) { freeLargePages(memory); }
    template <class U>
    void construct(U* place) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(static_cast<Arguments&&>(arguments)...);
    }

    friend bool operator==(const LargePageAllocator&, const LargePageAllocator&) { return true; }
};

/// A vector for millions of plain numbers. `resize` does not set them to zero.
template <class T>
using LargeVector = std::vector<T, LargePageAllocator<T>>;

}  // namespace tactooth

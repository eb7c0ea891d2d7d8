// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/large_pages.h"

#include <sys/mman.h>

#include <cstdlib>
#include <limits>

namespace tactooth {
namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;  // page size of x86-64, and of ARM with pages of 4 KB
constexpr std::size_t kCacheLine = 64;

std::size_t roundedUp(std::size_t bytes, std::size_t unit) { return (bytes + unit - 1) / unit * unit; }

}  // namespace

void* allocateOnLargePages(std::size_t bytes) noexcept {
    if (bytes > std::numeric_limits<std::size_t>::max() - kLargePage) return nullptr;
    if (bytes < 2 * kLargePage) return std::aligned_alloc(kCacheLine, roundedUp(bytes, kCacheLine));
    const std::size_t size = roundedUp(bytes, kLargePage);
    void* memory = std::aligned_alloc(kLargePage, size);
#ifdef MADV_HUGEPAGE
    if (memory != nullptr) ::madvise(memory, size, MADV_HUGEPAGE);  // only a hint: if it is refused, all works the same
#endif
    return memory;
}

void freeLargePages(void* memory) noexcept { std::free(memory); }

}  // namespace tactooth

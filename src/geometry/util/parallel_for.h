// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#if defined(__SANITIZE_THREAD__)  // GCC; asked first, since Eigen gives GCC a __has_feature that knows nothing
#define TACTOOTH_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TACTOOTH_THREAD_SANITIZER
#endif
#endif
#ifdef TACTOOTH_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace tactooth {
namespace detail {

/// Tells the thread sanitizer, which cannot look into TBB, the order that a parallel loop guarantees and no more: what
/// came before the loop is seen by its blocks, and these are seen by what comes after it. Two blocks have no order.
/// Does nothing in other builds.
class LoopOrder {
public:
#ifdef TACTOOTH_THREAD_SANITIZER
    LoopOrder() { __tsan_release(&begun_); }
    void beginBlock() { __tsan_acquire(&begun_); }
    void endBlock() { __tsan_release(&ended_); }
    void endLoop() { __tsan_acquire(&ended_); }

private:
    alignas(8) char begun_ = 0;  // only the addresses matter
    alignas(8) char ended_ = 0;
#else
    void beginBlock() {}
    void endBlock() {}
    void endLoop() {}
#endif
};

using LoopBlock = void (*)(void* loop, std::size_t begin, std::size_t end);

/// Covers 0..count with blocks of at least about `grain`, run on any thread; returns when all have ended.
void runBlocks(std::size_t count, std::size_t grain, LoopBlock block, void* loop);

}  // namespace detail

/// Calls function(i) for each i from 0 to count - 1, on all processors and in any order, and returns when all calls
/// have ended. The calls share nothing but what they only read. May be nested. `grain` calls at least make a piece of
/// work for another thread: give it where a single call is too short for that.
template <class Function>
void parallelFor(std::size_t count, const Function& function, std::size_t grain = 1) {
    struct Loop {
        const Function& function;
        detail::LoopOrder order;
    } loop{function, {}};
    const auto block = [](void* shared, std::size_t begin, std::size_t end) {
        Loop& all = *static_cast<Loop*>(shared);
        all.order.beginBlock();
        for (std::size_t i = begin; i < end; ++i) all.function(i);
        all.order.endBlock();
    };
    detail::runBlocks(count, grain, block, &loop);
    loop.order.endLoop();
}

/// While one of these lives, loops of this process use no more than so many threads, the one that calls them among
/// them: for measuring what work costs. Results never depend on it.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t most);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Limit;
    std::unique_ptr<Limit> limit_;
};

}  // namespace tactooth

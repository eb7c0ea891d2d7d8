// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#if defined(__SANITIZE_THREAD__)  // GCC; tested first, since Eigen defines for GCC a __has_feature that knows nothing
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

/// Reports to the thread sanitizer, which cannot look into TBB, the order that a parallel loop guarantees, and no more.
/// What was written before the loop is visible to its blocks, and what the blocks write is visible after the loop. Two
/// blocks have no order. Does nothing in other builds.
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

/// Runs blocks that cover 0..count, each of about `grain` or more, on any thread; returns when all have ended.
void runBlocks(std::size_t count, std::size_t grain, LoopBlock block, void* loop);

}  // namespace detail

/// Calls function(i) for each i from 0 to count - 1, on all processors and in any order, and returns when all calls
/// have ended. The calls share nothing but data that they only read. May be nested. A piece of work for another thread
/// has at least `grain` calls: set it where a single call is too short.
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

/// While an object lives, loops of this process use at most so many threads, including the calling thread. It is for
/// measurements. Results never depend on it.
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

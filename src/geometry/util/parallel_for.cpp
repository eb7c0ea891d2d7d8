// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The only file that includes the loops of TBB. A build with the thread sanitizer leaves it out (see CMakeLists.txt):
// half of the scheduler is in these headers, the other half in a library that the sanitizer does not see.
#include "geometry/util/parallel_for.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "geometry/util/assert.h"

namespace tactooth {
namespace detail {

void runBlocks(std::size_t count, std::size_t grain, LoopBlock block, void* loop) {
    TACTOOTH_ASSERT(grain > 0);
    TACTOOTH_ASSERT(block != nullptr && loop != nullptr);
    using Block = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Block(0, count, grain), [&](const Block& range) { block(loop, range.begin(), range.end()); });
}

}  // namespace detail

struct ThreadLimit::Limit {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(std::size_t most) : limit_(new Limit{{tbb::global_control::max_allowed_parallelism, most}}) {
    TACTOOTH_ASSERT(most > 0);
}
ThreadLimit::~ThreadLimit() = default;

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/assert.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace tactooth {
namespace {

void printAndAbort(const AssertFailure& failure) {
    std::fprintf(stderr, "%s:%d: %s: assertion failed: %s\n", failure.file, failure.line, failure.function,
                 failure.condition);
    std::abort();
}

std::atomic<AssertHandler> handlerInUse{&printAndAbort};

}  // namespace

AssertHandler setAssertHandler(AssertHandler handler) {
    return handlerInUse.exchange(handler != nullptr ? handler : &printAndAbort);
}

void assertFailed(const AssertFailure& failure) { handlerInUse.load()(failure); }

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth::test {

/// Whether this program is built with a sanitizer (address or thread).
constexpr bool isSanitized() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return true;
#elif defined(__has_feature)
    return __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
    return false;
#endif
}

/// How many cases of a long test to run: `all`, but `few` under a sanitizer. That makes each case ten to thirty times
/// slower, and what it looks for shows in few of them.
template <class Number>
constexpr Number cases(Number all, Number few) {
    return isSanitized() ? few : all;
}

}  // namespace tactooth::test

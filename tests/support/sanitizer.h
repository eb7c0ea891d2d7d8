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

/// Number of cases of a long test: `all`, or `few` under a sanitizer, which makes each case ten to thirty times slower
/// and needs few cases.
template <class Number>
constexpr Number cases(Number all, Number few) {
    return isSanitized() ? few : all;
}

}  // namespace tactooth::test

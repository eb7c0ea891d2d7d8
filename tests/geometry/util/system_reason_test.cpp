// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/system_reason.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace tactooth {
namespace {

constexpr int kMostErrors = 200;

TEST(SystemReason, IsInEnglishWhatTheSystemSays) {
    for (int reason = 1; reason < kMostErrors; ++reason) {
        EXPECT_EQ(systemReason(reason).in(Language::English), std::generic_category().message(reason)) << reason;
    }
}

TEST(SystemReason, TheUsualOnesHaveARow) {
    for (const int reason : {ENOENT, EACCES, ENOSPC, EROFS, EIO, EFBIG, EDQUOT}) {
        const Message message = systemReason(std::error_code(reason, std::system_category()));
        EXPECT_FALSE(message.id().empty()) << reason;
        EXPECT_NE(message.in(Language::Japanese), message.in(Language::English)) << reason;
    }
}

}  // namespace
}  // namespace tactooth

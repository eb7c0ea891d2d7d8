// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>

#include "session/recording/session_replay.h"

namespace tactooth::test {

/// Expects that the recording leads to this tooth (CutModel::hash), bit for bit.
inline void expectReplays(const std::filesystem::path& file, std::uint64_t hash) {
    const auto recording = SessionRecording::open(file);
    ASSERT_TRUE(recording) << recording.error().message();
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay) << replay.error().message();
    const auto played = replay->playUntil({}, {});
    ASSERT_TRUE(played) << played.error().message();
    EXPECT_FALSE(replay->differsAt()) << *replay->differsAt();
    EXPECT_EQ(replay->model().hash(), hash);
}

}  // namespace tactooth::test

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "session/recording/session_recording.h"

namespace tactooth {

/// What was written.
struct McapExport {
    double seconds = 0;
    std::uint64_t messages = 0;
    std::optional<double> differsAt = {};  ///< SessionReplay::differsAt: the file ends there
};

/// Replays a recording into an MCAP file, for programs that show robot data. Its channels, in JSON with schemas:
/// /tool/pose (foxglove.PoseInFrame of the tool's tip in the tooth's frame, mm), /tool/force (N, N*mm), /spindle and
/// /events (SessionMoments). Times are those of the recording, ns since 1970. At most `rateHz` messages a second on
/// each channel but the last, positive. Fails with one sentence as SessionReplay and AtomicFile do.
[[nodiscard]] Expected<McapExport> exportMcap(const SessionRecording& recording, const std::filesystem::path& path,
                                              double rateHz);

}  // namespace tactooth

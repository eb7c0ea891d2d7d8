// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "session/recording/session_text.h"

namespace tactooth {

/// The recordings with the parts of a session before and behind one part.
struct NeighbourParts {
    std::optional<std::filesystem::path> before, behind;
};
/// Looks into the folder of `file`, which holds `part`. What cannot be read is passed over.
[[nodiscard]] NeighbourParts neighbourParts(const std::filesystem::path& file, const RecordingPart& part);

}  // namespace tactooth

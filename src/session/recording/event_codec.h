// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "session/kernel/session_event.h"

namespace tactooth {

/// Most events of one block.
inline constexpr std::size_t kMaxBlockEvents = std::size_t{1} << 16;

/// The payload of a block of events (docs/session-file.md). There is no BeginEvent among them, and at most
/// kMaxBlockEvents.
[[nodiscard]] std::vector<std::byte> encodeEvents(std::span<const SessionEvent> events);

/// Reads what encodeEvents wrote; nothing for anything else. It takes memory in proportion to the payload.
[[nodiscard]] std::optional<std::vector<SessionEvent>> decodeEvents(std::span<const std::byte> payload);

}  // namespace tactooth

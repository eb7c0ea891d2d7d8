// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_fault.h"

#include <algorithm>
#include <array>

#include "devices/process/messages.h"

namespace tactooth {
namespace {

struct Row {
    HandFault fault;
    std::string_view name;
    const MessageText& text;
};

constexpr std::array<Row, 11> kRows = {{
    {HandFault::None, "none", msg::kForceCutByNothing},
    {HandFault::NoForce, "no_force", msg::kForceCutNoForce},
    {HandFault::ProgramStopped, "program_stopped", msg::kForceCutProgramStopped},
    {HandFault::ProgramEnded, "program_ended", msg::kForceCutProgramEnded},
    {HandFault::NotANumber, "not_a_number", msg::kForceCutNotANumber},
    {HandFault::BeyondLimits, "beyond_limits", msg::kForceCutBeyondLimits},
    {HandFault::WrongSequence, "wrong_sequence", msg::kForceCutWrongSequence},
    {HandFault::HandHangs, "hand_hangs", msg::kForceCutHandHangs},
    {HandFault::HandKilled, "hand_killed", msg::kForceCutHandKilled},
    {HandFault::HandStopped, "hand_stopped", msg::kForceCutHandStopped},
    {HandFault::HandEnded, "hand_ended", msg::kForceCutHandEnded},
}};

/// A number that is no cause, as a broken process may write it, counts as none.
const Row& rowOf(HandFault fault) {
    const auto* const found = std::ranges::find(kRows, fault, &Row::fault);
    return found == kRows.end() ? kRows.front() : *found;
}

}  // namespace

std::string_view nameOf(HandFault fault) { return rowOf(fault).name; }
const MessageText& textOf(HandFault fault) { return rowOf(fault).text; }

std::optional<HandFault> findHandFault(std::string_view name) {
    const auto* const found = std::ranges::find(kRows, name, &Row::name);
    return found == kRows.end() ? std::nullopt : std::optional(found->fault);
}

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "session/simulation/cut_events.h"

namespace tactooth {

/// What somebody was doing with a tooth, as a saved tooth and a recording keep it beside the tooth itself, so that
/// opening goes on where one stopped.
struct SessionWork {
    std::string title = {};         ///< of the tooth, for people
    std::string exercise = {};      ///< name of a built-in exercise, or of that in `exerciseFile`; empty: none
    std::string exerciseFile = {};  ///< description of the user's own exercise; empty: built in
    std::string targetFile = {};    ///< of the user's own target; empty: none
    std::string bur = {};           ///< its name, for people
    std::string burFile = {};       ///< that describes it; empty: of the catalogue, or of a case
    int mouthTooth = 0;             ///< FDI number, if the tooth stands in the whole built-in mouth; 0: it does not
    double seconds = 0;             ///< since the list of events began
    std::vector<CutEvent> events = {};
    bool isUnsaved = false;  ///< the tooth has cuts that no file of the user holds

    /// Whether there is nothing that a tooth alone does not say.
    [[nodiscard]] bool isEmpty() const {
        return exercise.empty() && targetFile.empty() && bur.empty() && events.empty();
    }
};

/// Most bytes of the text that is read.
inline constexpr std::size_t kMaxWorkBytes = std::size_t{4} << 20;

/// As JSON.
[[nodiscard]] std::string workText(const SessionWork& work);
/// The same with the names of files alone, without their folders: for a file that may be handed on.
[[nodiscard]] std::string workTextWithoutFolders(SessionWork work);
/// Reads what workText wrote. Values that are missing, damaged or of another version keep their defaults; nothing for a
/// text that is no such JSON. It never trusts the text: numbers are finite, and there are at most some thousand events.
[[nodiscard]] std::optional<SessionWork> parseWork(std::string_view text);

}  // namespace tactooth

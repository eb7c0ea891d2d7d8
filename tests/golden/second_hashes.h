// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tactooth::test {

/// What a session has come to at the end of one of its seconds.
struct SecondHash {
    int second = 0;      ///< from 1; the last one may be shorter than a second
    std::string volume;  ///< CutModel::hash, 16 hexadecimal digits
    std::string ticks;   ///< of the forces and places of the second's ticks (addToHash), 16 hexadecimal digits

    friend bool operator==(const SecondHash&, const SecondHash&) = default;
};

/// Replays a recording. Stops where the session itself finds that it differs.
[[nodiscard]] std::vector<SecondHash> replayedHashes(const std::filesystem::path& recording);

/// The hashes in a text file, one second in a line.
[[nodiscard]] std::vector<SecondHash> readHashes(const std::filesystem::path& file);
void writeHashes(const std::filesystem::path& file, const std::vector<SecondHash>& hashes);

/// One sentence that names the first second in which a replay differs; empty: none.
[[nodiscard]] std::string differenceOf(const std::vector<SecondHash>& recorded, const std::vector<SecondHash>& replayed,
                                       const std::string& name);

}  // namespace tactooth::test

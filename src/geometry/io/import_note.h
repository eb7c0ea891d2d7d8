// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tactooth {

/// The subject of an import note.
enum class ImportNoteTopic { File, Units, Orientation, Closedness, Layers };

/// An assumption, a change or a repair of the program: a sentence in which %1, %2 ... stand for `values`, so that a
/// window can show it in another language.
struct ImportNote {
    ImportNoteTopic topic;
    const char* text;
    std::vector<std::string> values = {};
};

/// The sentence in English.
[[nodiscard]] std::string inWords(const ImportNote& importNote);

/// `value` with so many digits after the point.
[[nodiscard]] std::string rounded(double value, int digits);

}  // namespace tactooth

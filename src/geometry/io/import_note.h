// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tactooth {

/// What a remark on a scanned surface is about.
enum class ImportNoteTopic { File, Units, Orientation, Closedness, Layers };

/// Something that the program has assumed or mended, in words: a sentence with the places %1, %2 ... for `values`, so
/// that a window can show it in another language.
struct ImportNote {
    ImportNoteTopic topic;
    const char* text;
    std::vector<std::string> values = {};
};

/// The sentence in English.
[[nodiscard]] std::string inWords(const ImportNote& importNote);

/// `value` with so many digits behind the point.
[[nodiscard]] std::string rounded(double value, int digits);

}  // namespace tactooth

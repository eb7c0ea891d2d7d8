// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/util/message.h"

namespace tactooth {

/// What a remark on a scanned surface is about.
enum class ImportNoteTopic { File, Units, Orientation, Closedness, Layers };

/// Something that the program has assumed or mended.
struct ImportNote {
    ImportNoteTopic topic;
    Message message;
};

/// The sentence in English.
[[nodiscard]] std::string inWords(const ImportNote& importNote);

/// `value` with so many digits behind the point.
[[nodiscard]] std::string rounded(double value, int digits);

}  // namespace tactooth

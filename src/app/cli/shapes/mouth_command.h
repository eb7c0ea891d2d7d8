// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/util/expected.h"
#include "instruments/builtin_mouth.h"

namespace tactooth {

/// The parameters of a mouth.
struct MouthSpec {
    int triangles = 20000;
    std::uint32_t seed = 0;
    std::string jaw = "closed";  ///< or "open"
    std::vector<int> missing;
    bool noCache = false;
};

/// Fails with a sentence if an entry of the missing teeth is not a tooth.
[[nodiscard]] Expected<BuiltinMouth> mouthFromSpec(const MouthSpec& spec);

struct MouthOptions {
    MouthSpec mouth;
    std::filesystem::path out;
};

/// Writes all teeth of a mouth in place, each into its own folder, and the gingiva of both jaws.
[[nodiscard]] int runMouth(const MouthOptions& options);

}  // namespace tactooth

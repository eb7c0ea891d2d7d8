// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/util/expected.h"

namespace tactooth {

/// A recording as an endless loop that can be played at any pitch.
///
/// The end is cross-faded into the beginning where the two are most similar, so that a tone keeps its phase. For higher
/// pitches the loop is also stored at a half, a quarter and an eighth of its rate, each low-passed against aliasing (L.
/// Williams, "Pyramidal parametrics", SIGGRAPH 1983, the idea for pictures).
class Recording {
public:
    static constexpr double kMinLength = 0.05, kMaxLength = 30.0;  ///< s
    static constexpr double kMinRate = 4000, kMaxRate = 192000;    ///< samples a second
    static constexpr int kLevels = 4;
    static constexpr int kTaps = 32;  ///< samples around a position that playing it needs

    /// Makes a loop of samples at `rate`; their mean is subtracted, and their root mean square becomes 1. Errors, about
    /// `name`: shorter or longer than a loop may be, a rate outside the limits, a sample that is not finite, silence.
    [[nodiscard]] static Expected<Recording> make(std::span<const float> mono, double rate, std::string_view name);

    /// Samples in the loop, a multiple of 2^(kLevels - 1).
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] double rate() const { return rate_; }
    /// The samples of a level from `kTaps / 2 - 1` before `place` on; `place` is less than size() >> level.
    [[nodiscard]] const float* around(int level, std::size_t place) const {
        return &levels_[static_cast<std::size_t>(level)][place];
    }

private:
    std::size_t size_ = 0;
    double rate_ = 0.0;
    std::array<std::vector<float>, kLevels> levels_;  // each with kTaps samples more, for positions near an end
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// `word` as toNumber<double> reads it, but adjusted so that rounding it to single precision gives the result of
/// toNumber<float>: a number that is rounded twice may differ in the last digit from one that is rounded once.
[[nodiscard]] inline std::optional<double> toCoordinate(std::string_view word) {
    const std::optional<double> value = toNumber<double>(word);
    if (!value) return value;
    constexpr std::uint64_t kDropped = (std::uint64_t{1} << 29) - 1;  // bits that a float lacks
    constexpr std::uint64_t kMiddle = std::uint64_t{1} << 28;         // of these: half between two floats
    const bool isMiddle = (std::bit_cast<std::uint64_t>(*value) & kDropped) == kMiddle;
    const bool isTiny = std::abs(*value) < static_cast<double>(std::numeric_limits<float>::min());
    if (!isMiddle && !isTiny) return value;
    const std::optional<float> once = toNumber<float>(word);
    if (!once || isTiny) return once ? std::optional<double>(*once) : value;
    return static_cast<float>(*value) == *once ? *value : std::nextafter(*value, static_cast<double>(*once));
}

/// Rounds the corners of a surface to single precision and measures the error. Where the error is too large, the reader
/// reads the file again and first subtracts an offset.
class PositionRounding {
public:
    explicit PositionRounding(const Vec3& offset) : offset_(offset), isMoved_(!offset.isZero(0)) {
        TACTOOTH_ASSERT(offset.allFinite());
    }

    /// The result is infinite where the position is too large, and not finite where the position is not.
    [[nodiscard]] Vec3f round(const Vec3& exact) {
        if (isMoved_) return (exact - offset_).cast<float>();
        const Vec3f rounded = exact.cast<float>();
        low_ = low_.cwiseMin(exact);
        high_ = high_.cwiseMax(exact);
        loss_ = std::max(loss_, (exact - rounded.cast<double>()).cwiseAbs().maxCoeff());
        return rounded;
    }

    /// The offset to subtract so that rounding does no harm; nothing where rounding does none, or where no offset
    /// helps. A corner may move by 1/40,000 of the longest side: half a micrometre for a molar.
    [[nodiscard]] std::optional<Vec3> betterOffset() const;

private:
    Vec3 offset_;
    bool isMoved_;
    Vec3 low_ = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
    double loss_ = 0;
};

}  // namespace tactooth

// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/position_rounding.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <string>

namespace tactooth {
namespace {

TEST(ToCoordinate, RoundsToTheFloatThatTheTextNames) {
    std::mt19937_64 random(20261125);
    for (int round = 0; round < 200'000; ++round) {
        // Texts close to the middle of two floats, where double rounding fails.
        const auto bits = static_cast<std::uint32_t>(random());
        const auto low = std::bit_cast<float>(bits);
        if (!std::isfinite(low) || !std::isfinite(std::nextafter(low, 1e38F))) continue;
        const double middle = 0.5 * (static_cast<double>(low) + static_cast<double>(std::nextafter(low, 1e38F)));
        std::string text = numberText(middle);
        if (text.find('e') == text.npos && text.find('.') != text.npos) text += random() % 2 == 0 ? "0000001" : "";
        const auto value = toCoordinate(text);
        ASSERT_TRUE(value) << text;
        ASSERT_EQ(static_cast<float>(*value), *toNumber<float>(text)) << text;
    }
    for (const char* const text : {"0", "-0", "1e-60", "1.4e-45", "1e-40", "3.5e38", "nan", "-1.17549435e-38"}) {
        const auto once = static_cast<float>(*toCoordinate(text));
        EXPECT_TRUE(once == *toNumber<float>(text) || (std::isnan(once) && std::isnan(*toNumber<float>(text)))) << text;
    }
    EXPECT_FALSE(toCoordinate("1,5"));
    EXPECT_FALSE(toCoordinate(""));
}

std::optional<Vec3> offsetFor(const Vec3& middle, double size, double step) {
    PositionRounding rounding(Vec3::Zero());
    for (double x = -size / 2; x <= size / 2; x += step)
        static_cast<void>(rounding.round(middle + Vec3(x, x / 2, 0.1)));
    return rounding.betterOffset();
}

TEST(PositionRounding, NearZeroNothingIsSubtracted) {
    EXPECT_FALSE(offsetFor(Vec3(0, 0, 0), 20, 0.123));
    EXPECT_FALSE(offsetFor(Vec3(150, -80, 1000), 20, 0.123));     // a scanner's frame, mm
    EXPECT_FALSE(offsetFor(Vec3(150e3, -80e3, 0), 20e3, 123.4));  // the same in micrometres
    EXPECT_FALSE(offsetFor(Vec3(0.1, 0.2, 0.3), 0.02, 1.23e-4));  // in metres
}

TEST(PositionRounding, FarFromZeroAShortNumberNearTheMiddleIsSubtracted) {
    const auto offset = offsetFor(Vec3(1'000'003, -2'000'004, 7), 20, 0.123);
    ASSERT_TRUE(offset);
    EXPECT_EQ(*offset, Vec3(1'000'000, -2'000'000, 10));
    EXPECT_TRUE(offsetFor(Vec3(0, 0, 1e6), 20, 0.123));
    EXPECT_TRUE(offsetFor(Vec3(1e9, 0, 0), 20e3, 123.4));
    EXPECT_TRUE(offsetFor(Vec3(1e5, 0, 0), 0.02, 1.23e-4));
    EXPECT_TRUE(offsetFor(Vec3(12'345'678, 0, 0), 8, 0.1));
}

TEST(PositionRounding, WhatRoundingDoesNotHarmStaysInPlace) {
    PositionRounding rounding(Vec3::Zero());
    for (const double x : {0.0, 4.0, 8.0}) static_cast<void>(rounding.round(Vec3(1e6 + x, 1e6, 2 * x)));
    EXPECT_FALSE(rounding.betterOffset());
}

}  // namespace
}  // namespace tactooth

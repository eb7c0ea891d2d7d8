// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// FDI numbers: ISO 3950. Universal numbers: American Dental Association. Palmer's corners are the lines of a cross
// between the quadrants, as the dentist sees them: the patient's right is on the left.
#include "instruments/notation/tooth_notation.h"

#include <array>

#include "geometry/util/assert.h"
#include "geometry/util/number_text.h"
#include "instruments/builtin_tooth.h"
#include "instruments/notation/messages.h"

namespace tactooth {
namespace {

constexpr int kPlaces = 8;  // teeth of a quadrant, counted from the midline

/// The teeth of a quadrant have the numbers first + step * place.
struct UniversalRow {
    int first, step;
};
constexpr std::array<UniversalRow, 4> kUniversal = {{{9, -1}, {8, 1}, {25, -1}, {24, 1}}};

struct PalmerCorner {
    std::string_view corner;
    bool isBehind;             // the corner stands behind the place
    std::string_view letters;  // in place of the corner
};
constexpr std::array<PalmerCorner, 4> kPalmer = {
    {{"┘", true, "UR"}, {"└", false, "UL"}, {"┌", false, "LL"}, {"┐", true, "LR"}}};

constexpr std::array<const MessageText*, 4> kQuadrants = {&msg::kUpperRight, &msg::kUpperLeft, &msg::kLowerLeft,
                                                          &msg::kLowerRight};
constexpr std::array<const MessageText*, kPlaces> kKinds = {
    &msg::kCentralIncisor, &msg::kLateralIncisor, &msg::kCanine,      &msg::kFirstPremolar,
    &msg::kSecondPremolar, &msg::kFirstMolar,     &msg::kSecondMolar, &msg::kThirdMolar};

std::size_t quadrantOf(int fdi) { return static_cast<std::size_t>(fdi / 10 - 1); }

/// The digits alone: neither a sign nor a leading zero.
std::optional<int> numberIn(std::string_view text) {
    if (text.empty() || text.size() > 2 || text.front() < '1' || text.front() > '9') return std::nullopt;
    return toNumber<int>(std::string(text));
}

std::optional<int> fromUniversal(std::string_view text) {
    const auto number = numberIn(text);
    if (!number) return std::nullopt;
    for (int quadrant = 1; quadrant <= 4; ++quadrant) {
        const UniversalRow& row = kUniversal[static_cast<std::size_t>(quadrant - 1)];
        const int place = row.step * (*number - row.first);
        if (place >= 1 && place <= kPlaces) return 10 * quadrant + place;
    }
    return std::nullopt;
}

std::optional<int> fromPalmer(std::string_view text) {
    for (std::size_t i = 0; i < kPalmer.size(); ++i) {
        const PalmerCorner& row = kPalmer[i];
        std::string_view place = text;
        if (text.starts_with(row.letters)) {
            place.remove_prefix(row.letters.size());
        } else if (row.isBehind && text.ends_with(row.corner)) {
            place.remove_suffix(row.corner.size());
        } else if (!row.isBehind && text.starts_with(row.corner)) {
            place.remove_prefix(row.corner.size());
        } else {
            continue;
        }
        const auto number = numberIn(place);
        if (!number || *number > kPlaces) return std::nullopt;
        return 10 * (static_cast<int>(i) + 1) + *number;
    }
    return std::nullopt;
}

}  // namespace

std::string toothLabel(int fdi, ToothNotation notation) {
    TACTOOTH_ASSERT(isPermanentTooth(fdi));
    const int place = fdi % 10;
    switch (notation) {
        case ToothNotation::Fdi:
            return std::to_string(fdi);
        case ToothNotation::Universal: {
            const UniversalRow& row = kUniversal[quadrantOf(fdi)];
            return std::to_string(row.first + row.step * place);
        }
        case ToothNotation::Palmer: {
            const PalmerCorner& row = kPalmer[quadrantOf(fdi)];
            const std::string corner(row.corner);
            return row.isBehind ? std::to_string(place) + corner : corner + std::to_string(place);
        }
    }
    return {};
}

std::optional<int> toothNamed(std::string_view text, ToothNotation notation) {
    if (notation == ToothNotation::Universal) return fromUniversal(text);
    if (notation == ToothNotation::Palmer) return fromPalmer(text);
    const auto number = numberIn(text);
    return number && isPermanentTooth(*number) ? number : std::nullopt;
}

Message toothTitle(int fdi) {
    TACTOOTH_ASSERT(isPermanentTooth(fdi));
    return {msg::kToothTitle, Message(*kQuadrants[quadrantOf(fdi)]),
            Message(*kKinds[static_cast<std::size_t>(fdi % 10 - 1)])};
}

}  // namespace tactooth

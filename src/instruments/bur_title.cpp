// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_title.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "instruments/messages.h"

namespace tactooth {
namespace {

constexpr std::array<const MessageText*, 25> kShapes = {
    &msg::kBurRound,
    &msg::kBurInvertedCone,
    &msg::kBurPear,
    &msg::kBurLongPear,
    &msg::kBurStraightFissure,
    &msg::kBurCrossCutStraightFissure,
    &msg::kBurDomeEndFissure,
    &msg::kBurTaperedFissure,
    &msg::kBurCrossCutTaperedFissure,
    &msg::kBurLongTaperedFissure,
    &msg::kBurRoundEndTaperedFissure,
    &msg::kBurDomeEndTaperedFissure,
    &msg::kBurBallFinishing,
    &msg::kBurEggFinishing,
    &msg::kBurNeedleFinishing,
    &msg::kBurFootball,
    &msg::kBurFlatEndCylinder,
    &msg::kBurFlatEndTaper,
    &msg::kBurRoundEndTaper,
    &msg::kBurNeedle,
    &msg::kBurFlame,
    &msg::kBurTorpedo,
    &msg::kBurTorpedoTaper,
    &msg::kBurRoundEndCylinder,
    &msg::kBurWheel,
};

Message shapeWord(std::string_view shape) {
    const auto* const known = std::ranges::find(kShapes, shape, &MessageText::english);
    return known == kShapes.end() ? Message::verbatim(std::string(shape)) : Message(**known);
}

}  // namespace

Message burKindTitle(BurKind kind) {
    switch (kind) {
        case BurKind::Round:
            return msg::kBurRound;
        case BurKind::InvertedCone:
            return msg::kBurInvertedCone;
        case BurKind::StraightFissure:
            return msg::kBurStraightFissure;
        case BurKind::DomeFissure:
            return msg::kBurDomeEndFissure;
        case BurKind::TaperedFissure:
            return msg::kBurTaperedFissure;
        case BurKind::RoundEndTaper:
            return msg::kBurRoundEndTaper;
        case BurKind::Pear:
            return msg::kBurPear;
        case BurKind::Flame:
            return msg::kBurFlame;
        case BurKind::Football:
            return msg::kBurFootball;
        case BurKind::Torpedo:
            return msg::kBurTorpedo;
        case BurKind::Needle:
            return msg::kBurNeedle;
        case BurKind::Wheel:
            return msg::kBurWheel;
    }
    return {};
}

Message burTitle(std::string_view shape, const BurSpec& bur) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), bur.headDiameter, std::chars_format::fixed, 1).ptr;
    const MessageText& row = bur.material == BurMaterial::Diamond ? msg::kDiamondBur : msg::kCarbideBur;
    return {row, shapeWord(shape), bur.number, std::string(digits.begin(), end) + " mm"};
}

}  // namespace tactooth
